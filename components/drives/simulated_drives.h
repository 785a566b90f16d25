#pragma once
// This is what the drives of the simulated arms have in common: power, goals, and brakes.

#include <suture/base/time.h>

#include <memory>

#include "drives/coupling.h"
#include "drives/drives.h"
#include "drives/motor_order.h"
#include "drives/simulated_joints.h"
#include "timing/stream_watch.h"

namespace robots {

/// Says how the joints of one arm follow their goals if they have no mass (joint_dynamics.h). Joint
/// vectors are in rad, or m for a prismatic joint.
template <int N>
struct DriveModel {
  using Joints = Eigen::Matrix<double, N, 1>;

  Joints lower, upper;   ///< the mechanical limits
  Joints parked;         ///< where the joints are when the drives start
  Joints rate_limit;     ///< rad/s or m/s
  double time_constant;  ///< s: how far the measured joints trail their goal
};

/// One thread; only the constructors allocate. A goal that arrives in one cycle acts on the joints
/// from that cycle on; measurements are of the time of the cycle.
template <int N>
class SimulatedDrives : public Drives {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  /// The drives have no power at first, and are not permitted to have any.
  explicit SimulatedDrives(std::unique_ptr<SimulatedJoints<N>> joints,
                           const Coupling<N>& coupling = {});
  /// Does the same with parked joints that trail their goals. Throws std::invalid_argument for
  /// impossible dynamics.
  explicit SimulatedDrives(const DriveModel<N>& model);

  void power_on(suture::Time permitted) override;
  void power_off() override;
  void servo_jp(const DriveGoal& goal) override;
  const DriveFeedback& feedback() const override { return feedback_; }

  /// Call this before each cycle to say if power is permitted. Without a permit the drives stop,
  /// and stay without power when it is there again.
  void permit(bool granted);

  /// Makes the brakes hold where the joints were in the last cycle, for when no other cycle may
  /// follow.
  void brake();

  /// Executes one cycle at time `now`, after the commands that arrived for it.
  void step(suture::Time now);

  /// Emits by `events` (what Provided<Drives>::emit() returns) what happened since the last call.
  template <class Events>
  void announce(Events&& events) {
    if (powerChanged_) events.power(feedback_.power);
    powerChanged_ = false;
  }

 private:
  void enter(DrivePower power);
  /// Holds all joints where they are, with the compensation that was asked for.
  void hold();

  std::unique_ptr<SimulatedJoints<N>> joints_;
  const Coupling<N> coupling_;  // goals and feedback are of actuators
  Joints goal_;
  MotorOrder<N> order_;
  StreamWatch stream_;
  suture::Time lastStep_;
  DriveFeedback feedback_;
  bool powerChanged_ = true;
};

extern template class SimulatedDrives<6>;
extern template class SimulatedDrives<7>;
extern template class SimulatedDrives<8>;

}  // namespace robots
