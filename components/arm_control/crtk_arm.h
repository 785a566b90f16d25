#pragma once
// This provides the contract Arm over a controller.

#include <suture/standard/message_draft.h>

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "arm/arm.h"
#include "arm_control/arm_controller.h"
#include "arm_control/motion/motion_stream.h"
#include "arm_control/motion/stream_goals.h"
#include "arm_control/period_statistics.h"
#include "arm_control/tip_reads.h"

namespace robots {

/// Belongs to the arm's thread; only the constructor allocates. If the drives control no efforts,
/// an effort moves the set-point at a speed proportional to it.
template <int N>
class CrtkArm final : public Arm {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  /// `arm` must outlive this.
  explicit CrtkArm(ArmController<N>& arm);

  /// Call this before the first cycle, with the frames that the interface has declared. The data
  /// name them.
  void nameFrames(const suture::Frames& frames);

  const JointConfiguration& configuration_js() const override { return configuration_; }
  const OperatingState& operating_state() const override { return arm_.operating_state(); }
  IntervalStatistics period_statistics() const override { return periods_.last(); }
  void enable() override { arm_.obey(StateCommand::Enable); }
  void disable() override { arm_.obey(StateCommand::Disable); }
  void pause() override { arm_.obey(StateCommand::Pause); }
  void resume() override { arm_.obey(StateCommand::Resume); }
  void home() override { arm_.obey(StateCommand::Home); }
  void unhome() override { arm_.obey(StateCommand::Unhome); }
  void state_command(const std::string& name) override;

  const JointState& measured_js() const override { return arm_.motion().measured_js(); }
  const JointState& setpoint_js() const override { return arm_.motion().setpoint_js(); }
  const JointState& goal_js() const override { return goalJs_; }
  PoseStamped measured_cp() const override { return inReference(arm_.motion().measured_cp()); }
  PoseStamped setpoint_cp() const override { return inReference(arm_.motion().setpoint_cp()); }
  PoseStamped goal_cp() const override { return inReference(goalCp_); }
  PoseStamped local_measured_cp() const override { return arm_.motion().measured_cp(); }
  PoseStamped local_setpoint_cp() const override { return arm_.motion().setpoint_cp(); }
  const Twist& measured_cv() const override { return tip_.measured_cv(); }
  const Twist& setpoint_cv() const override { return tip_.setpoint_cv(); }
  const Wrench& body_measured_cf() const override { return tip_.body_measured_cf(); }
  const Wrench& spatial_measured_cf() const override { return tip_.spatial_measured_cf(); }
  const CartesianState& measured_cs() const override { return tip_.measured_cs(); }
  const Jacobian& body_jacobian() const override { return tip_.body_jacobian(); }
  const Jacobian& spatial_jacobian() const override { return tip_.spatial_jacobian(); }
  const TransformStamped& base_frame() const override { return base_; }
  void set_base_frame(const TransformStamped& base) override;

  void hold() override { arm_.hold(); }
  void free() override;
  void use_gravity_compensation(bool use) override;
  void servo_jp(const JointGoal& goal) override { arm_.servo_jp(goal); }
  void servo_jr(const JointGoal& step) override;
  void servo_jv(const JointVelocityGoal& goal) override;
  void servo_jf(const JointEffortGoal& goal) override;
  void servo_cp(const PoseStamped& goal) override;
  void servo_cr(const PoseStamped& step) override;
  void servo_cv(const TwistGoal& goal) override;
  void body_servo_cf(const WrenchGoal& goal) override;
  void spatial_servo_cf(const WrenchGoal& goal) override;
  void interpolate_jp(const JointGoal& goal) override { arm_.interpolate_jp(goal); }
  void interpolate_jr(const JointGoal& step) override;
  void interpolate_cp(const PoseStamped& goal) override;
  void interpolate_cr(const PoseStamped& step) override;
  void move_jp(const JointGoal& goal) override { arm_.move_jp(goal); }
  void move_jr(const JointGoal& step) override;
  void move_cp(const PoseStamped& goal) override { moveTo(inBase(goal)); }
  void move_cr(const PoseStamped& step) override;
  void trajectory_j_set_ratio(double ratio) override { setRatios(ratio, ratio); }
  void trajectory_j_set_ratio_v(double ratio) override { setRatios(ratio, ratioA_); }
  void trajectory_j_set_ratio_a(double ratio) override { setRatios(ratioV_, ratio); }
  double trajectory_j_ratio() const override { return std::min(ratioV_, ratioA_); }
  double trajectory_j_ratio_v() const override { return ratioV_; }
  double trajectory_j_ratio_a() const override { return ratioA_; }

  PoseStamped forward_kinematics(const JointGoal& q) const override;
  JointSolution inverse_kinematics(const PoseStamped& goal) const override;
  PoseStamped query_cp(const JointGoal& q) const override { return inReference(local_query_cp(q)); }
  PoseStamped local_query_cp(const JointGoal& q) const override;

  /// Call this before the arm's step() of a cycle. It moves the set-point by a stream of velocities
  /// or efforts.
  void advance(suture::Time now);
  /// Call this after the arm's step(). It evaluates what the reads answer.
  void publish(suture::Time now);
  /// Returns what the motors do from this cycle on beside following the set-point. Call this after
  /// the arm's step(), which may have ended what a client asked of them.
  MotorOrder<N> motorOrder() const;

  /// Emits by `events` (what Provided<Arm>::emit() returns) what happened since the last call.
  template <class Events>
  void announce(Events&& events) {
    if (arm_.desired_) events.desired_state(*arm_.desired_);
    if (arm_.stateChanged_) events.operating_state(arm_.state_);
    if (arm_.moveEnded_) events.goal_reached(*arm_.moveEnded_);
    if (ratiosChanged_) {
      events.trajectory_j_ratio(trajectory_j_ratio());
      events.trajectory_j_ratio_v(ratioV_);
      events.trajectory_j_ratio_a(ratioA_);
    }
    if (gravityChanged_) events.gravity_compensation(gravityCompensation_);
    if (arm_.stateChanged_ && !arm_.state_.sub_state.empty()) {
      events.status(message(arm_.state_.sub_state));
    }
    arm_.warnings_.forEachNew([&](ArmWarning reason) {
      const suture::Message& text = message(textOf(reason), static_cast<std::uint32_t>(reason));
      isError(reason) ? events.error(text) : events.warning(text);
    });
    if (!error_.empty()) events.error(message(error_));
    arm_.forgetNews();
    ratiosChanged_ = gravityChanged_ = false;
    error_ = {};
  }

 private:
  using Stream = MotionStream<N>;

  std::string_view textOf(ArmWarning reason);
  static bool isError(ArmWarning reason) {
    return isOfJoint(reason) || reason == ArmWarning::WrongState ||
           reason == ArmWarning::PowerLost || reason == ArmWarning::DrivesSilent;
  }
  const suture::Message& message(std::string_view text, std::uint32_t code = 0) {
    return draft_.write(text, code, ++messages_);
  }
  PoseStamped inReference(PoseStamped pose) const;
  PoseStamped inBase(PoseStamped pose) const;
  /// Return the goal that is `step` from the joints `from`.
  PoseStamped stepped(const Joints& from, const PoseStamped& step) const;
  std::optional<typename ArmController<N>::ServoTarget> stepped(const Joints& from,
                                                                const JointGoal& step);
  void moveTo(const PoseStamped& goal);
  void setRatios(double velocity, double acceleration);
  bool streaming() const;
  void endPreviousStream();
  /// Says that a goal of a stream has come. Returns true if the arm obeys it.
  bool streams(bool may, bool isWellFormed, const char* activity);
  void drive(const std::optional<JointStreamGoal<N>>& goal, const char* activity);
  /// `axes` rotates from the axes of the goal to those of the base.
  void drive(typename Stream::Kind kind, const std::optional<TwistStreamGoal>& goal,
             const char* activity, const Eigen::Matrix3d& axes);
  /// Lets the drives press with a wrench, or a twist move the set-point of those that cannot.
  void press(typename Stream::Kind wrench, typename Stream::Kind twist, const WrenchGoal& goal);

  ArmController<N>& arm_;
  PeriodStatistics periods_;
  suture::FrameId referenceFrame_ = 0;
  TransformStamped base_;
  double ratioV_ = 1, ratioA_ = 1;
  bool gravityCompensation_ = true;

  Stream stream_;              // another activity of the arm ends it
  bool streamSlides_ = false;  // along a joint limit
  bool streamFails_ = false;   // because it leads out of reach
  StreamWatch referred_;       // goals of streams in the reference frame, obeyed or not
  suture::Time lastCycle_{};

  JointGoal moveGoal_;  // keeps its memory
  JointConfiguration configuration_;
  JointState goalJs_;
  PoseStamped goalCp_;
  TipReads<N> tip_;

  bool ratiosChanged_ = true, gravityChanged_ = true;
  std::string_view error_;  // it lives as long as the program
  std::string ofJoint_;     // keeps its memory
  suture::MessageDraft draft_;
  std::uint32_t messages_ = 0;  // how many have been emitted
};

extern template class CrtkArm<6>;
extern template class CrtkArm<7>;

}  // namespace robots
