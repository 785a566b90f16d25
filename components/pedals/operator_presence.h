#pragma once
// The contract of what tells that a surgeon sits at the console.

#include <suture/annotate.h>
#include <suture/base/time.h>

namespace robots {

/// A head in the viewer. It counts for as long as it is fresh.
struct SUTURE_TYPE() Presence {
  bool present = false;
  /// The cycle that it was looked for in.
  suture::Time stamp;
};

class SUTURE_INTERFACE() OperatorPresence {
 public:
  virtual ~OperatorPresence() = default;

  SUTURE_COMMAND() virtual Presence presence() const = 0;

  /// Each change, and as it is now to whoever connects.
  SUTURE_EVENT(latched()) suture::EventOf<bool> operator_present;
};

}  // namespace robots
