#pragma once
// This is what a client knows of an arm's readiness, and how it makes an arm ready.

#include <suture/component/required.h>

#include <utility>

#include "arm/arm.suture.h"
#include "arm/arm_warning.h"

namespace robots {

/// Belongs to the thread of the component that owns the required interface, which has it as a
/// member declared after that interface. Follows the operating state of the arm behind it.
class ArmWatch {
 public:
  explicit ArmWatch(suture::Required<Arm>& arm) : arm_(arm) {
    arm_.on().operating_state([this](const OperatingState& state) {
      const bool ended = busy_ && !state.is_busy;
      state_ = state.state;
      homed_ = state.is_homed;
      busy_ = state.is_busy;
      const bool streamed = std::exchange(streams_, state.sub_state == "servo_cp");
      fellSilent_ = fellSilent_ || (streamed && !streams_);
      homing_ = homing_ && !ended && !homed_ && isEnabled();
      enableAsked_ = enableAsked_ || isEnabled();
      homeAsked_ = homeAsked_ || homed_;
    });
    arm_.on().warning([this](const suture::Message& warning) {
      const auto reason = static_cast<ArmWarning>(warning.code);
      brokenOff_ = brokenOff_ || reason == ArmWarning::StepTooFar;
      refuses_ = refuses_ || reason == ArmWarning::NotInserted;
    });
  }
  ArmWatch(const ArmWatch&) = delete;
  ArmWatch& operator=(const ArmWatch&) = delete;

  /// Returns true if the arm has power and knows where it is.
  bool isUp() const { return isEnabled() && homed_; }
  /// Returns true if a move is under way.
  bool busy() const { return busy_; }
  /// Returns true if the arm obeys servo commands.
  bool ready() const { return isUp() && !busy_; }

  /// Returns true if the arm has refused a goal since the last call because it lies too far from
  /// the set-point. A client that streams goals must then begin anew from where the arm is, because
  /// the arm would refuse all further ones.
  bool hasBrokenOff() { return std::exchange(brokenOff_, false); }

  /// Returns true if the arm carries out the goals of servo_cp that it gets. Goals that come too
  /// late are dropped without a word, so a client must not say before that an arm follows it.
  bool streams() const { return streams_; }
  /// Returns true if the arm has ceased to do so since the last call though nobody asked it to by
  /// hold(). Then the next goal may be far from where it holds, so a client must begin anew.
  bool hasFallenSilent() { return std::exchange(fellSilent_, false); }

  /// Returns true if the arm has refused a goal since the last call and will refuse the next one,
  /// because its tool is not in. An arm tells all of its clients what it refuses any of them, so
  /// other warnings may be about a goal of somebody else.
  bool refuses() { return std::exchange(refuses_, false); }

  /// Call this once a cycle. It enables and homes the arm, each at most once and only if nobody
  /// else has, so that an arm which someone disabled, or which came back after a failure, stays
  /// disabled, and one which someone made forget its home is not moved there.
  void prepare() {
    if (state_ == ArmState::Disabled && !enableAsked_) {
      enableAsked_ = arm_.enable().has_value();
    } else if (isEnabled() && !homed_ && !busy_ && !homeAsked_) {
      homeAsked_ = homing_ = arm_.home().has_value();
    }
  }
  /// Ends a way home that prepare() began: the arm holds where it is, and prepare() may home it
  /// again. Leaves an arm alone that somebody else moves.
  void stopHoming() {
    if (!std::exchange(homing_, false)) return;
    homeAsked_ = false;
    hold();
  }
  /// Lets the arm hold where it is.
  void hold() {
    if (arm_.hold()) streams_ = false;
  }
  /// Lets prepare() enable and home the arm once more, if it is not. An operator has to decide it.
  void permit() {
    enableAsked_ = isEnabled();
    homeAsked_ = homed_;
  }

 private:
  bool isEnabled() const { return state_ == ArmState::Enabled; }

  suture::Required<Arm>& arm_;
  ArmState state_ = ArmState::Undefined;
  bool homed_ = false;
  bool busy_ = false;
  bool brokenOff_ = false;
  bool streams_ = false, fellSilent_ = false;
  bool refuses_ = false;
  bool enableAsked_ = false;  // prepare() has asked since permit(), or the arm was enabled
  bool homeAsked_ = false;    // the same of its home
  bool homing_ = false;       // by this object
};

}  // namespace robots
