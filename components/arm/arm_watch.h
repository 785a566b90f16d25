#pragma once
// What a client knows of an arm's readiness, and how it makes an arm ready.

#include <suture/component/required.h>

#include <utility>

#include "arm/arm.suture.h"
#include "arm/arm_warning.h"

namespace robots {

/// Follows the operating state of the arm behind one required interface. A member of the component
/// that owns that interface, declared after it; belongs to the same thread.
class ArmWatch {
 public:
  explicit ArmWatch(suture::Required<Arm>& arm) : arm_(arm) {
    arm_.on().operating_state([this](const OperatingState& state) {
      state_ = state.state;
      homed_ = state.is_homed;
      busy_ = state.is_busy;
    });
    arm_.on().warning([this](const suture::Message& warning) {
      const auto reason = static_cast<ArmWarning>(warning.code);
      brokenOff_ = brokenOff_ || reason == ArmWarning::StepTooFar;
      refuses_ = refuses_ || reason == ArmWarning::NotInserted || reason == ArmWarning::Malformed;
    });
  }
  ArmWatch(const ArmWatch&) = delete;
  ArmWatch& operator=(const ArmWatch&) = delete;

  /// The arm has power and knows where it is.
  bool isUp() const { return state_ == ArmState::Enabled && homed_; }
  /// A move is under way.
  bool busy() const { return busy_; }
  /// The arm obeys servo commands.
  bool ready() const { return isUp() && !busy_; }

  /// Since the last call the arm has refused a goal that lies too far from its set-point: whoever
  /// streams goals begins anew, from where the arm is, or the arm would refuse them for ever.
  bool hasBrokenOff() { return std::exchange(brokenOff_, false); }

  /// Since the last call the arm has refused a goal, and will refuse the next one: its tool is not
  /// in, or the goal is no pose.
  bool refuses() { return std::exchange(refuses_, false); }

  /// Once a cycle: enables and homes the arm, each at most once, so that an arm which someone
  /// disabled, or which came back after a failure, stays disabled.
  void prepare() {
    if (state_ == ArmState::Disabled && !enableAsked_) {
      enableAsked_ = arm_.enable().has_value();
    } else if (state_ == ArmState::Enabled && !homed_ && !busy_ && !homeAsked_) {
      homeAsked_ = arm_.home().has_value();
    }
  }
  /// An operator's decision: prepare() may ask again.
  void permit() { enableAsked_ = homeAsked_ = false; }

 private:
  suture::Required<Arm>& arm_;
  ArmState state_ = ArmState::Undefined;
  bool homed_ = false;
  bool busy_ = false;
  bool brokenOff_ = false;
  bool refuses_ = false;
  bool enableAsked_ = false;
  bool homeAsked_ = false;
};

}  // namespace robots
