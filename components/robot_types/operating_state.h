#pragma once
// This says what an arm is ready for.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <cstdint>
#include <string>

namespace robots {

/// An ArmState is one of the states of CRTK.
enum class SUTURE_TYPE() ArmState : std::uint8_t { Undefined, Disabled, Enabled, Paused, Fault };

/// An OperatingState is CRTK's operating_state.
struct SUTURE_TYPE() OperatingState {
  ArmState state = ArmState::Undefined;
  /// Says for people what the arm is doing within its state: "holding", "servo_cp".
  SUTURE_FIELD(capacity(15)) std::string sub_state;
  bool is_homed = false;
  /// This is true while a move is under way; servo commands do not set it.
  bool is_busy = false;
  /// One of the above changed last at this time.
  suture::Time stamp;
};

}  // namespace robots
