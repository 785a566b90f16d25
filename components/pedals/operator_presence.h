#pragma once
// This is the contract of a sensor that tells if a surgeon sits at the console.

#include <suture/annotate.h>
#include <suture/base/time.h>

namespace robots {

/// Says if a head is in the viewer. It counts only as long as it is fresh.
struct SUTURE_TYPE() Presence {
  bool present = false;
  /// The cycle in which the viewer was looked at.
  suture::Time stamp;
};

class SUTURE_INTERFACE() OperatorPresence {
 public:
  virtual ~OperatorPresence() = default;

  SUTURE_COMMAND() virtual Presence presence() const = 0;

  /// Reports each change, and the present state to a client that connects.
  SUTURE_EVENT(latched()) suture::EventOf<bool> operator_present;
};

}  // namespace robots
