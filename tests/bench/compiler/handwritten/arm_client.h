#pragma once
// The thread of its event loop uses this. It is a client of the complete arm interface, written by
// hand on Cap'n Proto: a method for each command, a handler for each event.

#include <kj/async.h>

#include <functional>
#include <string>

#include "bench/compiler/handwritten/conversions.h"

namespace handwritten {

/// This is a value and when the arm made it.
template <class T>
struct Stamped {
  T value;
  suture::Time stamp;
};

/// ArmHandlers hear what a subscriber is told. Handlers that are empty are not called.
struct ArmHandlers {
  std::function<void(const robots::OperatingState&)> operating_state;
  std::function<void(robots::ArmState)> desired_state;
  std::function<void(bool)> goal_reached;
  std::function<void(bool)> gravity_compensation;
  std::function<void(double)> trajectory_j_ratio;
  std::function<void(double)> trajectory_j_ratio_v;
  std::function<void(double)> trajectory_j_ratio_a;
  std::function<void(const suture::Message&)> status;
  std::function<void(const suture::Message&)> warning;
  std::function<void(const suture::Message&)> error;
};

/// The newest row of what the arm's reads answer; bit i of `evaluated`: column i is there.
struct ArmState {
  suture::Time stamp;
  std::uint64_t evaluated = 0;
  robots::JointConfiguration configuration_js;
  robots::OperatingState operating_state;
  robots::IntervalStatistics period_statistics;
  robots::JointState measured_js;
  robots::JointState setpoint_js;
  robots::JointState goal_js;
  robots::PoseStamped measured_cp;
  robots::PoseStamped setpoint_cp;
  robots::PoseStamped goal_cp;
  robots::PoseStamped local_measured_cp;
  robots::PoseStamped local_setpoint_cp;
  robots::Twist measured_cv;
  robots::Twist setpoint_cv;
  robots::Wrench body_measured_cf;
  robots::Wrench spatial_measured_cf;
  robots::CartesianState measured_cs;
  robots::Jacobian body_jacobian;
  robots::Jacobian spatial_jacobian;
  robots::TransformStamped base_frame;
  double trajectory_j_ratio{};
  double trajectory_j_ratio_v{};
  double trajectory_j_ratio_a{};
};

class ArmClient {
 public:
  explicit ArmClient(wire::Arm::Client arm) : arm_(kj::mv(arm)) {}

  /// Asks for all events and for the columns in `columns`; `state` is written with each row.
  /// Both must outlive the connection.
  kj::Promise<void> subscribe(ArmHandlers& handlers, ArmState& state, std::uint64_t columns);

  kj::Promise<Stamped<robots::JointConfiguration>> configuration_js();
  kj::Promise<Stamped<robots::OperatingState>> operating_state();
  kj::Promise<Stamped<robots::IntervalStatistics>> period_statistics();
  kj::Promise<Stamped<robots::JointState>> measured_js();
  kj::Promise<Stamped<robots::JointState>> setpoint_js();
  kj::Promise<Stamped<robots::JointState>> goal_js();
  kj::Promise<Stamped<robots::PoseStamped>> measured_cp();
  kj::Promise<Stamped<robots::PoseStamped>> setpoint_cp();
  kj::Promise<Stamped<robots::PoseStamped>> goal_cp();
  kj::Promise<Stamped<robots::PoseStamped>> local_measured_cp();
  kj::Promise<Stamped<robots::PoseStamped>> local_setpoint_cp();
  kj::Promise<Stamped<robots::Twist>> measured_cv();
  kj::Promise<Stamped<robots::Twist>> setpoint_cv();
  kj::Promise<Stamped<robots::Wrench>> body_measured_cf();
  kj::Promise<Stamped<robots::Wrench>> spatial_measured_cf();
  kj::Promise<Stamped<robots::CartesianState>> measured_cs();
  kj::Promise<Stamped<robots::Jacobian>> body_jacobian();
  kj::Promise<Stamped<robots::Jacobian>> spatial_jacobian();
  kj::Promise<Stamped<robots::TransformStamped>> base_frame();
  kj::Promise<Stamped<double>> trajectory_j_ratio();
  kj::Promise<Stamped<double>> trajectory_j_ratio_v();
  kj::Promise<Stamped<double>> trajectory_j_ratio_a();

  kj::Promise<void> enable();
  kj::Promise<void> disable();
  kj::Promise<void> pause();
  kj::Promise<void> resume();
  kj::Promise<void> home();
  kj::Promise<void> unhome();
  kj::Promise<void> hold();
  kj::Promise<void> free();

  kj::Promise<void> state_command(const std::string& name);
  kj::Promise<void> set_base_frame(const robots::TransformStamped& base);
  kj::Promise<void> use_gravity_compensation(bool use);
  kj::Promise<void> servo_jp(const robots::JointGoal& goal);
  kj::Promise<void> servo_jr(const robots::JointGoal& step);
  kj::Promise<void> servo_jv(const robots::JointVelocityGoal& goal);
  kj::Promise<void> servo_jf(const robots::JointEffortGoal& goal);
  kj::Promise<void> servo_cp(const robots::PoseStamped& goal);
  kj::Promise<void> servo_cr(const robots::PoseStamped& step);
  kj::Promise<void> servo_cv(const robots::TwistGoal& goal);
  kj::Promise<void> body_servo_cf(const robots::WrenchGoal& goal);
  kj::Promise<void> spatial_servo_cf(const robots::WrenchGoal& goal);
  kj::Promise<void> interpolate_jp(const robots::JointGoal& goal);
  kj::Promise<void> interpolate_jr(const robots::JointGoal& step);
  kj::Promise<void> interpolate_cp(const robots::PoseStamped& goal);
  kj::Promise<void> interpolate_cr(const robots::PoseStamped& step);
  kj::Promise<void> move_jp(const robots::JointGoal& goal);
  kj::Promise<void> move_jr(const robots::JointGoal& step);
  kj::Promise<void> move_cp(const robots::PoseStamped& goal);
  kj::Promise<void> move_cr(const robots::PoseStamped& step);
  kj::Promise<void> trajectory_j_set_ratio(double ratio);
  kj::Promise<void> trajectory_j_set_ratio_v(double ratio);
  kj::Promise<void> trajectory_j_set_ratio_a(double ratio);

  kj::Promise<robots::PoseStamped> forward_kinematics(const robots::JointGoal& q);
  kj::Promise<robots::JointSolution> inverse_kinematics(const robots::PoseStamped& goal);
  kj::Promise<robots::PoseStamped> query_cp(const robots::JointGoal& q);
  kj::Promise<robots::PoseStamped> local_query_cp(const robots::JointGoal& q);

 private:
  wire::Arm::Client arm_;
};

}  // namespace handwritten
