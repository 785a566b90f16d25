#pragma once
// This is the contract of an emergency stop. It is no safety function in the sense of ISO 13850,
// because it runs in software, on an ordinary network.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <cstdint>

namespace robots {

/// Lets drives have power. It counts only as long as it is fresh, so that drives that do not
/// receive it any more stop too.
struct SUTURE_TYPE() Permit {
  bool granted = false;
  /// The coordinator renewed it in the cycle of this stamp.
  suture::Time stamp;
  /// The number of the last press is also in StopNews::press.
  std::uint64_t press = 0;
};

/// Says that the emergency stop was pressed, or released.
struct SUTURE_TYPE() StopNews {
  bool pressed = false;
  suture::Time stamp;
  /// This is true if nobody has pressed it: the coordinator has just started, and starts pressed.
  bool is_start = false;
  /// Identifies the last press, and so does release(). No two presses have the same one, nor has
  /// one of a coordinator that ran before.
  std::uint64_t press = 0;
};

/// Commands run in the coordinator's thread before its next cycle.
class SUTURE_INTERFACE(version(2)) EmergencyStop {
 public:
  virtual ~EmergencyStop() = default;

  /// Stops all drives. None has power until release().
  SUTURE_COMMAND() virtual void press() = 0;
  /// Lets drives have power again, which an operator must have decided. `press` is that of the news
  /// that this answers: it does nothing if somebody has pressed since. Arms stay disabled until
  /// somebody enables them, such as a console that brings its system up by itself.
  SUTURE_COMMAND() virtual void release(std::uint64_t press) = 0;

  /// The coordinator renews the permit in each cycle.
  SUTURE_COMMAND() virtual Permit permit() const = 0;

  /// Reports each press and each release, and the last one to a client that connects.
  SUTURE_EVENT(latched()) suture::EventOf<StopNews> stop;
};

}  // namespace robots
