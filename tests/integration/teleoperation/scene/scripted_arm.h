#pragma once
// An arm that is always ready, stands where the test puts it and keeps the goals that it gets.

#include <suture/component/provided.h>
#include <suture/component/task/periodic_task.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <mutex>
#include <optional>
#include <vector>

#include "arm/arm.suture.h"
#include "arm/arm_warning.h"
#include "integration/teleoperation/scene/still_arm.h"

namespace robots::test {

/// Its public methods are any thread's, those of the contract its own.
class ScriptedArm final : public suture::PeriodicTask, public StillArm {
 public:
  ScriptedArm() : PeriodicTask({.period = std::chrono::milliseconds(1)}) {
    port_.keepState({.manual = true});
    base_.valid = true;
  }
  ~ScriptedArm() override { stop(); }

  /// Measures and holds this pose from now on.
  void place(const Eigen::Isometry3d& pose) {
    const std::lock_guard lock(mutex_);
    pose_ = pose;
  }
  Eigen::Isometry3d pose() const {
    const std::lock_guard lock(mutex_);
    return pose_;
  }
  /// Says so, whatever the reason.
  void warn(ArmWarning reason) {
    const std::lock_guard lock(mutex_);
    said_ = reason;
  }
  /// While it is silent it works, but publishes no row.
  void beSilent(bool silent) {
    const std::lock_guard lock(mutex_);
    silent_ = silent;
  }
  /// While its encoders are stuck it publishes rows with the earlier pose.
  void beStuck(bool stuck) {
    const std::lock_guard lock(mutex_);
    stuck_ = stuck;
  }
  /// Stamps what it measures by a clock that is wrong by so much.
  void stampAhead(suture::Duration by) {
    const std::lock_guard lock(mutex_);
    ahead_ = by;
  }
  /// Refuses goals that lie farther from where it is, m.
  void refuseStepsBeyond(double distance) {
    const std::lock_guard lock(mutex_);
    longestStep_ = distance;
  }
  /// Drops goals without a word, as those are that come late.
  void missGoals(bool miss) {
    const std::lock_guard lock(mutex_);
    missesGoals_ = miss;
  }
  /// Slides along a limit: its z stays above, m, whatever goal it takes.
  void stayAbove(double z) {
    const std::lock_guard lock(mutex_);
    lowest_ = z;
  }
  /// Says from now on that it is a gantry of three slides along its axes and three turns about
  /// them, whose third slide stays above, m.
  void beAGantryAbove(double z) {
    const std::lock_guard lock(mutex_);
    configuration_.name = {"x", "y", "z", "about x", "about y", "about z"};
    configuration_.position_min.assign(6, -kFar);
    configuration_.position_max.assign(6, kFar);
    configuration_.position_min[2] = z;
    configuration_.valid = true;
    jacobian_.joints = 6;
    jacobian_.coefficients.assign(36, 0);
    for (std::size_t i = 0; i < 6; ++i) jacobian_.coefficients[7 * i] = 1;
    jacobian_.valid = true;
  }
  /// Gives its poses from now on in a base that stands so far from the one before, as
  /// set_base_frame() does.
  void rebase(const Eigen::Vector3d& by) {
    const std::lock_guard lock(mutex_);
    base_.transform.pretranslate(by);
    pose_.pretranslate(by);
  }
  /// Says that it hangs with its base turned about the x axis of its poses, so that the third slide
  /// of its gantry goes downward.
  void hangUpsideDown() {
    const std::lock_guard lock(mutex_);
    base_.transform.rotate(Eigen::AngleAxisd(EIGEN_PI, Eigen::Vector3d::UnitX()));
    configuration_.position_max[2] = -configuration_.position_min[2];
    configuration_.position_min[2] = -kFar;
  }
  /// Says of that gantry also how it is turned about z, and that it cannot be turned farther, rad.
  void turnUpTo(double angle) {
    const std::lock_guard lock(mutex_);
    configuration_.position_max[5] = angle;
    saysTurn_ = true;
  }
  /// Says where it was so many cycles ago, as an arm does that is far away.
  void answerLate(std::size_t cycles) {
    const std::lock_guard lock(mutex_);
    late_ = cycles;
  }
  /// Makes it say that it is not homed; home() is a way without an end, which hold() ends.
  void forgetHome() {
    const std::lock_guard lock(mutex_);
    forgot_ = true;
  }
  /// Returns how often it was told to go home.
  std::size_t homes() const {
    const std::lock_guard lock(mutex_);
    return homes_;
  }
  /// Does not move by itself: it ignores move_cp.
  void refuseMoves(bool refuse) {
    const std::lock_guard lock(mutex_);
    refusesMoves_ = refuse;
  }
  /// Makes it say from its next cycle on that it is disabled; it obeys goals all the same.
  void sayDisabled(bool disabled) {
    const std::lock_guard lock(mutex_);
    saysDisabled_ = disabled;
  }
  /// Returns how often it was told to move by itself, and to hold.
  std::size_t moves() const {
    const std::lock_guard lock(mutex_);
    return moves_;
  }
  std::size_t holds() const {
    const std::lock_guard lock(mutex_);
    return holds_;
  }
  /// Returns the goals of servo_cp that it has obeyed.
  std::vector<PoseStamped> goals() const {
    const std::lock_guard lock(mutex_);
    return goals_;
  }
  /// Returns the wrenches of body_servo_cf that it has got.
  std::vector<WrenchGoal> wrenches() const {
    const std::lock_guard lock(mutex_);
    return wrenches_;
  }
  void forgetGoals() {
    const std::lock_guard lock(mutex_);
    goals_.clear();
    wrenches_.clear();
  }

  void servo_cp(const PoseStamped& goal) override {
    const std::lock_guard lock(mutex_);
    if (missesGoals_) return;
    if ((goal.pose.translation() - pose_.translation()).norm() > longestStep_) {
      suture::Message refusal;
      refusal.code = static_cast<std::uint32_t>(ArmWarning::StepTooFar);
      port_.emit().warning(refusal);
      return;
    }
    goals_.push_back(goal);
    activity_ = "servo_cp";
    obeyed_ = suture::now();
    pose_ = goal.pose;
    pose_.translation().z() = std::max(pose_.translation().z(), lowest_);
  }
  void body_servo_cf(const WrenchGoal& goal) override {
    const std::lock_guard lock(mutex_);
    wrenches_.push_back(goal);
  }
  /// It is there in no time.
  void move_cp(const PoseStamped& goal) override {
    const std::lock_guard lock(mutex_);
    ++moves_;
    if (!refusesMoves_) pose_ = goal.pose;
  }
  void home() override {
    const std::lock_guard lock(mutex_);
    ++homes_;
    homing_ = forgot_;
  }
  void hold() override {
    const std::lock_guard lock(mutex_);
    ++holds_;
    homing_ = false;
    activity_ = "holding";
  }
  PoseStamped measured_cp() const override { return {pose(), stamp_, true}; }
  PoseStamped setpoint_cp() const override {
    const std::lock_guard lock(mutex_);
    return {past_.empty() ? pose_ : past_.front(), stamp_, true};
  }
  const OperatingState& operating_state() const override { return state_; }
  const JointConfiguration& configuration_js() const override { return configuration_; }
  const Jacobian& spatial_jacobian() const override { return jacobian_; }
  const TransformStamped& base_frame() const override { return base_; }
  const JointState& setpoint_js() const override {
    const Eigen::Vector3d place = base_frame().transform.inverse() * pose().translation();
    const Eigen::Matrix3d turned = pose().linear();
    const double turn = saysTurn_ ? std::atan2(turned(1, 0), turned(0, 0)) : 0;
    setpointJs_.valid = jacobian_.valid;
    setpointJs_.position.assign({place.x(), place.y(), place.z(), 0, 0, turn});
    return setpointJs_;
  }

 private:
  static constexpr double kFar = 10;

  void onStart() override { tellStateIfNew(); }
  void run() override {
    tellWarning();
    tellStateIfNew();
    if (!isSilent()) port_.advance();
  }
  void tellWarning() {
    const std::lock_guard lock(mutex_);
    if (!said_) return;
    suture::Message message;
    message.code = static_cast<std::uint32_t>(*said_);
    port_.emit().warning(message);
    said_.reset();
  }
  void tellStateIfNew() {
    const std::lock_guard lock(mutex_);
    if (suture::now() - obeyed_ > std::chrono::milliseconds(100)) activity_ = "holding";
    const ArmState state = saysDisabled_ ? ArmState::Disabled : ArmState::Enabled;
    const bool isNew = state != state_.state || state_.is_homed == forgot_ ||
                       state_.is_busy != homing_ || state_.sub_state != activity_;
    state_.state = state;
    state_.is_homed = !forgot_;
    state_.is_busy = homing_;
    state_.sub_state = activity_;
    if (isNew) port_.emit().operating_state(state_);
  }
  bool isSilent() {
    const std::lock_guard lock(mutex_);
    past_.push_back(pose_);
    while (past_.size() > late_ + 1) past_.pop_front();
    if (!stuck_) stamp_ = suture::now() + ahead_;
    return silent_;
  }

  mutable std::mutex mutex_;
  Eigen::Isometry3d pose_ = Eigen::Isometry3d::Identity();
  std::vector<PoseStamped> goals_;
  std::vector<WrenchGoal> wrenches_;
  std::deque<Eigen::Isometry3d> past_;  // the oldest first, with the present pose
  std::size_t late_ = 0;                // cycles
  double longestStep_ = std::numeric_limits<double>::infinity();
  double lowest_ = -std::numeric_limits<double>::infinity();
  std::size_t moves_ = 0, holds_ = 0, homes_ = 0;
  std::optional<ArmWarning> said_;
  bool forgot_ = false, homing_ = false;
  bool silent_ = false, stuck_ = false, missesGoals_ = false, refusesMoves_ = false,
       saysDisabled_ = false;
  std::atomic<bool> saysTurn_ = false;
  suture::Time stamp_;
  suture::Duration ahead_{0};
  OperatingState state_;
  const char* activity_ = "holding";
  suture::Time obeyed_;  // when it obeyed the last goal
  JointConfiguration configuration_;
  Jacobian jacobian_;
  TransformStamped base_;
  mutable JointState setpointJs_;
  suture::Provided<Arm> port_{*this, "Arm", *this};
};

}  // namespace robots::test
