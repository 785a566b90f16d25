#pragma once
// The contract of an emergency stop: who may press it, and what drives live by. It is no safety
// function in the sense of ISO 13850: it runs in software, on an ordinary network.

#include <suture/annotate.h>
#include <suture/base/time.h>

namespace robots {

/// It lets drives have power. It counts for as long as it is fresh, so that whoever does not
/// hear of it any more stops too.
struct SUTURE_TYPE() Permit {
  bool granted = false;
  /// The cycle that it was renewed in.
  suture::Time stamp;
};

/// The emergency stop was pressed, or released.
struct SUTURE_TYPE() StopNews {
  bool pressed = false;
  suture::Time stamp;
};

/// Commands run in the coordinator's thread before its next cycle.
class SUTURE_INTERFACE() EmergencyStop {
 public:
  virtual ~EmergencyStop() = default;

  /// All drives stop, and none has power until release().
  SUTURE_COMMAND() virtual void press() = 0;
  /// An operator's decision: drives may have power again. Arms stay disabled until somebody enables
  /// them, such as a console that brings its system up by itself.
  SUTURE_COMMAND() virtual void release() = 0;

  /// Renewed in each cycle.
  SUTURE_COMMAND() virtual Permit permit() const = 0;

  /// Each press and each release, and the last one to whoever connects.
  SUTURE_EVENT(latched()) suture::EventOf<StopNews> stop;
};

}  // namespace robots
