#pragma once
// These are the parts of a system as its console sees them. Each belongs to the thread of the
// component that owns its required interface, which has it as a member declared after that
// interface.

#include <suture/component/required.h>

#include <functional>
#include <string>

#include "arm/arm.suture.h"
#include "guidance/guidance.suture.h"
#include "teleop/teleoperation.suture.h"

namespace robots {

/// Is an arm, which gets power, homes, and is disabled.
class ArmPart {
 public:
  explicit ArmPart(suture::Required<Arm>& arm) : arm_(arm) {
    arm_.on().operating_state([this](const OperatingState& state) {
      state_ = state.state;
      homed_ = state.is_homed;
      busy_ = state.is_busy;
      hasMoved_ = hasMoved_ || state.is_busy;
    });
  }
  ArmPart(const ArmPart&) = delete;
  ArmPart& operator=(const ArmPart&) = delete;

  const std::string& name() const { return arm_.name(); }

  /// Call this once a cycle. What an arm has reported counts only as long as it is connected.
  void look() {
    if (arm_.connected()) return;
    state_ = ArmState::Undefined;
    homed_ = busy_ = false;
  }
  /// Returns true if it has reported its state, and may have power.
  bool isThere() const { return state_ != ArmState::Undefined; }
  bool isEnabled() const { return state_ == ArmState::Enabled; }
  bool isHomed() const { return isEnabled() && homed_; }
  bool isReady() const { return isHomed() && !busy_; }
  bool isDown() const { return !isThere() || state_ == ArmState::Disabled; }

  /// Says that a bring-up begins.
  void begin() { hasMoved_ = false; }
  void enable() { (void)arm_.enable(); }
  /// Asks the arm to home. One that has begun to move is not asked again, because somebody may have
  /// stopped it.
  void home() {
    if (!homed_ && !hasMoved_) (void)arm_.home();
  }
  void disable() { (void)arm_.disable(); }

 private:
  suture::Required<Arm>& arm_;
  ArmState state_ = ArmState::Undefined;
  bool homed_ = false;
  bool busy_ = false;
  bool hasMoved_ = false;  // since the bring-up began
};

/// Is what moves arms: a teleoperation or a guide.
class MoverPart {
 public:
  explicit MoverPart(suture::Required<Teleoperation>& teleoperation)
      : interface_(teleoperation),
        enable_([&teleoperation] { (void)teleoperation.enable(); }),
        disable_([&teleoperation] { (void)teleoperation.disable(); }) {
    teleoperation.on().teleop_state(
        [this](const TeleopState& state) { hear(state == TeleopState::Disabled); });
  }
  explicit MoverPart(suture::Required<Guidance>& guidance)
      : interface_(guidance),
        enable_([&guidance] { (void)guidance.enable(); }),
        disable_([&guidance] { (void)guidance.disable(); }) {
    guidance.on().guidance_state(
        [this](const GuidanceState& state) { hear(state == GuidanceState::Disabled); });
  }
  MoverPart(const MoverPart&) = delete;
  MoverPart& operator=(const MoverPart&) = delete;

  const std::string& name() const { return interface_.name(); }

  /// Call this once a cycle, as for an arm.
  void look() {
    if (!interface_.connected()) heard_ = false;
  }
  bool isThere() const { return heard_; }
  bool isReady() const { return heard_ && !disabled_; }
  bool isDown() const { return !isReady(); }

  void enable() { enable_(); }
  void disable() { disable_(); }

 private:
  void hear(bool disabled) {
    heard_ = true;
    disabled_ = disabled;
  }

  suture::RequiredBase& interface_;
  const std::function<void()> enable_, disable_;
  bool heard_ = false;
  bool disabled_ = true;
};

}  // namespace robots
