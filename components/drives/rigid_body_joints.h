#pragma once
// These are simulated joints with mass: motors, controllers, encoders and brakes around the motion
// of an arm.

#include "drives/coupling.h"
#include "drives/encoders.h"
#include "drives/rate_filter.h"
#include "drives/simulated_joints.h"
#include "dynamics/davinci_inertia.h"
#include "dynamics/joint_motion.h"

namespace robots {

/// Describes one arm. Joint vectors are in rad, or m for a prismatic joint; efforts in N.m, or N.
template <int N>
struct RigidBodyModel {
  using Joints = Eigen::Matrix<double, N, 1>;

  kinematics::Chain<N> chain;  ///< the mechanical stops are its limits
  dynamics::ArmMechanics<N> mechanics;
  Joints parked;      ///< where the joints are at first
  Joints rate_limit;  ///< rad/s or m/s: set-points go no faster to their goals
  Joints stiffness;   ///< effort per error of position
  Joints damping;     ///< effort per error of velocity
  /// The velocities that are measured and controlled have this time constant, in s.
  double velocity_filter;
  bool gravity_compensation = true;
  bool quantisation = true;
  double noise = 0;  ///< counts of the encoders
  std::uint32_t seed = 1;
  double current_gain = 1;    ///< the share of each effort that is measured
  bool brakes = true;         ///< if not, only friction holds the joints without power
  Coupling<N> coupling = {};  ///< couples the motors and encoders with the joints
};

/// One thread; only the constructor throws or allocates. Each joint has a PD controller, which sees
/// what the encoders measure, runs once a cycle, and gives its motor no more than the motor can. An
/// order of efforts is added to that; a joint that is released has no controller, but is slowed
/// down above its rate limit. Compensation begins and ends gradually, so that no joint jerks.
/// Brakes, if there are any, hold at once and without slip. Equal models, commands and times give
/// equal motion.
template <int N>
class RigidBodyJoints final : public SimulatedJoints<N> {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  /// The joints are at rest, without power. Throws std::invalid_argument unless rates are positive
  /// and gains, noise and filter are not negative.
  explicit RigidBodyJoints(const RigidBodyModel<N>& model);

  void advance(double dt) override;
  void command(const Joints& setpoint) override;
  void order(const MotorOrder<N>& order) override { order_ = order; }
  void brake() override;
  const Joints& measured() const override { return encoders_.measured(); }
  Joints velocity() const override { return encoders_.velocity(); }
  /// Returns the efforts until the next command, as the motors' currents show them.
  Joints effort() const override { return model_.current_gain * effort_; }
  bool measuresEffort() const override { return true; }

  /// Returns where the joints really are, which only a simulation knows.
  const Joints& position() const { return motion_.position(); }

 private:
  void compensate(double dt);
  Joints controlled() const;

  RigidBodyModel<N> model_;
  dynamics::JointMotion<N> motion_;
  Encoders<N> encoders_;
  RateFilter<N> setpointRate_;  // as late as the measured velocities are
  Joints setpoint_;
  MotorOrder<N> order_;
  double carried_ = 0;  // the share of the arm's weight that the motors carry
  Joints effort_ = Joints::Zero();
  double elapsed_ = 0;  // s since the last command
  bool powered_ = false;
};

extern template class RigidBodyJoints<6>;
extern template class RigidBodyJoints<7>;

}  // namespace robots
