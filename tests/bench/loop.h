#pragma once
// This is the contract of the paper's two loops (its section 4): from a server to its client and
// back, and from a client to its server and back.

#include <suture/annotate.h>

#include "robot_types/pose.h"

namespace bench {

/// What the server of a loop offers.
class SUTURE_INTERFACE() LoopServer {
 public:
  virtual ~LoopServer() = default;
  /// Server, client, server: takes back what value() answered and measures how long it was away.
  SUTURE_COMMAND() virtual void put(const robots::PosePrm& value) = 0;
  /// Client, server, client: sends the value back as the event echo.
  SUTURE_COMMAND() virtual void bounce(const robots::PosePrm& value) = 0;
  /// A pose, stamped when it is evaluated.
  SUTURE_COMMAND() virtual const robots::PosePrm& value() const = 0;
  /// The value that bounce() took.
  SUTURE_EVENT() suture::EventOf<robots::PosePrm> echo;
};

}  // namespace bench
