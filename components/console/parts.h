#pragma once
// These are the parts of a system as its console sees them. Each belongs to the thread of the
// component that owns its required interface, which has it as a member declared after that
// interface.

#include <suture/component/required.h>

#include <functional>
#include <string>
#include <utility>

#include "arm/arm.suture.h"
#include "arm/arm_warning.h"
#include "guidance/guidance.suture.h"
#include "teleop/teleoperation.suture.h"

namespace robots {

/// Tells if what a provider has reported by events still counts. One that is suspended says nothing
/// new when it goes on, because its connection is the same; a connection made anew begins with it.
class Hearing {
 public:
  explicit Hearing(suture::RequiredBase& interface) : interface_(interface) {}

  /// Call this once a cycle. Returns false if what was reported has to be forgotten.
  bool look() {
    const suture::Errc why = interface_.unusable();
    counts_ = why == suture::Errc{};
    return why != suture::Errc::Lost && why != suture::Errc::NotConnected;
  }
  /// Returns true if the provider could report a change now.
  bool counts() const { return counts_; }

 private:
  suture::RequiredBase& interface_;
  bool counts_ = false;
};

/// An ArmPart is an arm, which gets power, homes, and is disabled.
class ArmPart {
 public:
  explicit ArmPart(suture::Required<Arm>& arm) : arm_(arm), hearing_(arm) {
    arm_.on().operating_state([this](const OperatingState& state) {
      heard_ = true;
      state_ = state.state;
      // It could not say what took its power while it was cut off.
      if (std::exchange(wasCutOff_, false)) lostPower_ = lostPower_ || state_ == ArmState::Disabled;
      homed_ = state.is_homed;
      busy_ = state.is_busy;
      hasMoved_ = hasMoved_ || state.is_busy;
    });
    arm_.on().error([this](const suture::Message& error) {
      lostPower_ = lostPower_ || error.code == static_cast<std::uint32_t>(ArmWarning::PowerLost);
    });
  }
  ArmPart(const ArmPart&) = delete;
  ArmPart& operator=(const ArmPart&) = delete;

  const std::string& name() const { return arm_.name(); }

  /// Call this once a cycle.
  void look() {
    if (hearing_.look()) return;
    if (state_ == ArmState::Enabled) lostPower_ = wasCutOff_ = true;
    state_ = ArmState::Undefined;
    heard_ = homed_ = busy_ = false;
  }
  /// Returns true if it has reported its state.
  bool isHeard() const { return hearing_.counts() && heard_; }
  /// Returns true if it has been permitted power since its process began, because an arm leaves
  /// UNDEFINED by nothing else, and homes with power. Drives that need no permit have it at once.
  bool wasUsed() const { return isHeard() && (homed_ || state_ != ArmState::Undefined); }
  /// Returns true if it has reported its state, and may have power.
  bool isThere() const { return hearing_.counts() && state_ != ArmState::Undefined; }
  bool isEnabled() const { return hearing_.counts() && state_ == ArmState::Enabled; }
  bool isHomed() const { return isEnabled() && homed_; }
  /// Returns true if it knows its position since it homed, though it may have no power by now.
  bool hasHomed() const { return isThere() && homed_; }
  bool isReady() const { return isHomed() && !busy_; }
  bool isFaulted() const { return hearing_.counts() && state_ == ArmState::Fault; }
  /// Returns true for an arm without power, which may be in FAULT.
  bool isDown() const { return !isThere() || state_ == ArmState::Disabled || isFaulted(); }
  /// Returns true if it has said since the last call that its drives lost their power, or may not
  /// have it. An enabled arm that is cut off is thought to have lost it, and again if it comes back
  /// disabled.
  bool hasLostPower() { return std::exchange(lostPower_, false); }

  /// Says that a bring-up begins.
  void begin() { hasMoved_ = false; }
  /// Says that a pause of the machine ends, which has stopped the arm if it was busy. One that was
  /// not busy when the pause began may have been stopped by somebody.
  void goOn() { hasMoved_ = hasMoved_ && !wasBusy_; }
  /// Call this at the end of each cycle.
  void endCycle() { wasBusy_ = busy_; }
  void enable() { (void)arm_.enable(); }
  /// Asks the arm to home. One that has begun to move is not asked again, because somebody may have
  /// stopped it.
  void home() {
    if (!homed_ && !hasMoved_) (void)arm_.home();
  }
  void disable() { (void)arm_.disable(); }

 private:
  suture::Required<Arm>& arm_;
  Hearing hearing_;
  ArmState state_ = ArmState::Undefined;
  bool heard_ = false;
  bool homed_ = false;
  bool busy_ = false;
  bool hasMoved_ = false;  // since the bring-up began
  bool wasBusy_ = false;   // at the end of the last cycle
  bool lostPower_ = false;
  bool wasCutOff_ = false;  // while it was enabled, and it has said nothing since
};

/// A MoverPart is what moves arms: a teleoperation or a guide.
class MoverPart {
 public:
  explicit MoverPart(suture::Required<Teleoperation>& teleoperation)
      : interface_(teleoperation),
        hearing_(teleoperation),
        enable_([&teleoperation] { (void)teleoperation.enable(); }),
        disable_([&teleoperation] { (void)teleoperation.disable(); }) {
    teleoperation.on().teleop_state(
        [this](const TeleopState& state) { hear(state == TeleopState::Disabled); });
  }
  explicit MoverPart(suture::Required<Guidance>& guidance)
      : interface_(guidance),
        hearing_(guidance),
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
    if (!hearing_.look()) heard_ = false;
  }
  bool isThere() const { return hearing_.counts() && heard_; }
  bool isReady() const { return isThere() && !disabled_; }
  bool isDown() const { return !isReady(); }

  void enable() { enable_(); }
  void disable() { disable_(); }

 private:
  void hear(bool disabled) {
    heard_ = true;
    disabled_ = disabled;
  }

  suture::RequiredBase& interface_;
  Hearing hearing_;
  const std::function<void()> enable_, disable_;
  bool heard_ = false;
  bool disabled_ = true;
};

}  // namespace robots
