#pragma once
// This says what an arm is ready for.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <cstdint>
#include <string>

namespace robots {

/// The states of CRTK.
enum class SUTURE_TYPE() ArmState : std::uint8_t { Undefined, Disabled, Enabled, Paused, Fault };

/// CRTK's operating_state.
struct SUTURE_TYPE() OperatingState {
  ArmState state = ArmState::Undefined;
  /// What the arm is doing within its state, for people: "holding", "servo_cp".
  SUTURE_FIELD(capacity(15)) std::string sub_state;
  bool is_homed = false;
  /// A move is under way; servo commands do not set it.
  bool is_busy = false;
  /// When the arm entered this state.
  suture::Time stamp;
};

}  // namespace robots
