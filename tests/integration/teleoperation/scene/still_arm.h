#pragma once
// This is an arm that does nothing: a test's own arm derives from it.

#include <string>

#include "arm/arm.h"

namespace robots::test {

/// Obeys no command, and answers every question with a default value.
class StillArm : public Arm {
 public:
  const JointConfiguration& configuration_js() const override { return configuration_; }
  const OperatingState& operating_state() const override { return operatingState_; }
  IntervalStatistics period_statistics() const override { return {}; }
  void enable() override {}
  void disable() override {}
  void pause() override {}
  void resume() override {}
  void home() override {}
  void unhome() override {}
  void state_command(const std::string&) override {}

  const JointState& measured_js() const override { return joints_; }
  const JointState& setpoint_js() const override { return joints_; }
  const JointState& goal_js() const override { return joints_; }
  PoseStamped measured_cp() const override { return {}; }
  PoseStamped setpoint_cp() const override { return {}; }
  PoseStamped goal_cp() const override { return {}; }
  PoseStamped local_measured_cp() const override { return {}; }
  PoseStamped local_setpoint_cp() const override { return {}; }
  const Twist& measured_cv() const override { return twist_; }
  const Twist& setpoint_cv() const override { return twist_; }
  const Wrench& body_measured_cf() const override { return wrench_; }
  const Wrench& spatial_measured_cf() const override { return wrench_; }
  const CartesianState& measured_cs() const override { return cartesian_; }
  const Jacobian& body_jacobian() const override { return jacobian_; }
  const Jacobian& spatial_jacobian() const override { return jacobian_; }
  const TransformStamped& base_frame() const override { return base_; }
  void set_base_frame(const TransformStamped&) override {}

  void hold() override {}
  void free() override {}
  void use_gravity_compensation(bool) override {}
  void servo_jp(const JointGoal&) override {}
  void servo_jr(const JointGoal&) override {}
  void servo_jv(const JointVelocityGoal&) override {}
  void servo_jf(const JointEffortGoal&) override {}
  void servo_cp(const PoseStamped&) override {}
  void servo_cr(const PoseStamped&) override {}
  void servo_cv(const TwistGoal&) override {}
  void body_servo_cf(const WrenchGoal&) override {}
  void spatial_servo_cf(const WrenchGoal&) override {}
  void interpolate_jp(const JointGoal&) override {}
  void interpolate_jr(const JointGoal&) override {}
  void interpolate_cp(const PoseStamped&) override {}
  void interpolate_cr(const PoseStamped&) override {}
  void move_jp(const JointGoal&) override {}
  void move_jr(const JointGoal&) override {}
  void move_cp(const PoseStamped&) override {}
  void move_cr(const PoseStamped&) override {}
  void trajectory_j_set_ratio(double) override {}
  void trajectory_j_set_ratio_v(double) override {}
  void trajectory_j_set_ratio_a(double) override {}
  double trajectory_j_ratio() const override { return 1; }
  double trajectory_j_ratio_v() const override { return 1; }
  double trajectory_j_ratio_a() const override { return 1; }

  PoseStamped forward_kinematics(const JointGoal&) const override { return {}; }
  JointSolution inverse_kinematics(const PoseStamped&) const override { return {}; }
  PoseStamped query_cp(const JointGoal&) const override { return {}; }
  PoseStamped local_query_cp(const JointGoal&) const override { return {}; }

 private:
  JointConfiguration configuration_;
  OperatingState operatingState_;
  JointState joints_;
  Twist twist_;
  Wrench wrench_;
  CartesianState cartesian_;
  Jacobian jacobian_;
  TransformStamped base_;
};

}  // namespace robots::test
