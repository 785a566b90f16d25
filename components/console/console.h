#pragma once
// This is the contract of a console, which brings a system up and down, in order.

#include <suture/annotate.h>
#include <suture/standard/messages.h>

#include <cstdint>

namespace robots {

enum class SUTURE_TYPE() ConsoleState : std::uint8_t {
  Down,        ///< until bring_up()
  Enabling,    ///< the arms get power, one after the other
  Homing,      ///< they move to their home positions
  Up,          ///< the arms are ready, and what moves them is enabled
  Incomplete,  ///< it was up, and a part is missing or not ready; up again when all are
  Leaving,     ///< bring_down() is under way, or a bring-up that failed is taken back
};

/// Says if the arms of a system have had power since their processes began. Then somebody may have
/// pressed the emergency stop before its coordinator began, which does not know of it.
enum class SUTURE_TYPE() SystemUse : std::uint8_t {
  Unknown,  ///< some arm has not said it
  Unused,   ///< none has been permitted power
  Used,
};

/// Commands run in the console's own thread before its next cycle. Status, warning and error are
/// the standard messages: they say what is missing, and which part did not do what it was asked. A
/// warning with the code of ArmWarning::PowerLost (arm/arm_warning.h) names an arm whose drives
/// have lost their power, or may not have it.
class SUTURE_INTERFACE() Console : public suture::Messages {
 public:
  virtual ~Console() = default;

  /// Brings the system up. It is refused, with an error that names each reason, unless the console
  /// is down, every part of the system is there, no arm is in FAULT, and the emergency stop is
  /// released.
  SUTURE_COMMAND() virtual void bring_up() = 0;
  /// Disables everything in the opposite order, even while the system is being brought up, and
  /// also what others have enabled. An arm in FAULT has no power, and stays in FAULT until somebody
  /// enables or disables it.
  SUTURE_COMMAND() virtual void bring_down() = 0;

  SUTURE_COMMAND() virtual ConsoleState console_state() const = 0;

  /// Reports each change, and the last one to a client that connects.
  SUTURE_EVENT(latched(), name("console_state"))
  suture::EventOf<ConsoleState> console_state_event;
  /// Reports each change, and the present one to a client that connects.
  SUTURE_EVENT(latched()) suture::EventOf<SystemUse> system_use;
};

}  // namespace robots
