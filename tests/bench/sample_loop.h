#pragma once
// This is the contract of `suture-bench local`: it has every kind of traffic with the 120-byte
// pose.

#include <suture/annotate.h>

#include "robot_types/pose.h"

namespace bench {

class SUTURE_INTERFACE() SampleServer {
 public:
  virtual ~SampleServer() = default;
  /// Counted by the provider.
  SUTURE_COMMAND(queue(4096)) virtual void put(const robots::PoseSample& value) = 0;
  /// Client, server, client: sends the value back as the event echo.
  SUTURE_COMMAND() virtual void bounce(const robots::PoseSample& value) = 0;
  SUTURE_COMMAND() virtual robots::PoseSample value() const = 0;
  /// The value that bounce() took.
  SUTURE_EVENT() suture::EventOf<robots::PoseSample> echo;
};

}  // namespace bench
