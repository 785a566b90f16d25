#include "drives/simulated_drives.h"

#include <algorithm>
#include <utility>

#include "drives/joint_dynamics.h"
#include "robot_types/rigid_pose.h"
#include "timing/seconds.h"

namespace robots {

template <int N>
SimulatedDrives<N>::SimulatedDrives(std::unique_ptr<SimulatedJoints<N>> joints,
                                    const Coupling<N>& coupling)
    : joints_(std::move(joints)), coupling_(coupling), goal_(joints_->measured()) {
  static_assert(N <= int{kMaxJoints});
  feedback_.joints = N;
  feedback_.measures_effort = feedback_.controls_effort = joints_->measuresEffort();
}

template <int N>
SimulatedDrives<N>::SimulatedDrives(const DriveModel<N>& model)
    : SimulatedDrives(std::make_unique<JointDynamics<N>>(model.time_constant, model.rate_limit,
                                                         model.lower, model.upper, model.parked)) {}

template <int N>
void SimulatedDrives<N>::power_on(suture::Time permitted) {
  const bool isMeant = permitted == feedback_.permitted;
  if (isMeant && feedback_.power == DrivePower::Off) enter(DrivePower::On);
}

template <int N>
void SimulatedDrives<N>::power_off() {
  if (feedback_.power == DrivePower::On) enter(DrivePower::Off);
}

template <int N>
void SimulatedDrives<N>::servo_jp(const DriveGoal& goal) {
  const Joints q = coupling_.joints(Joints::Map(goal.position.data()));
  const Joints effort = coupling_.jointEfforts(Joints::Map(goal.effort.data()));
  const bool meant = goal.joints == N && canBeMeant(q) && canBeMeant(effort);
  if (feedback_.power != DrivePower::On || !meant) return;
  goal_ = q;
  order_ = {.effort = effort,
            .released = Eigen::Array<bool, N, 1>::Map(goal.released.data()),
            .compensation = goal.gravity_compensation};
  stream_.ask();
}

template <int N>
void SimulatedDrives<N>::permit(bool granted) {
  const bool mayHavePower = feedback_.power == DrivePower::Off || feedback_.power == DrivePower::On;
  if (granted && !mayHavePower) {
    feedback_.permitted = suture::now();
    enter(DrivePower::Off);
  }
  if (!granted && mayHavePower) enter(DrivePower::Stopped);
}

template <int N>
void SimulatedDrives<N>::brake() {
  power_off();
  hold();
  joints_->brake();
}

template <int N>
void SimulatedDrives<N>::step(suture::Time now) {
  constexpr double kMost = SimulatedJoints<N>::kLongestStep;
  if (lastStep_ != suture::Time{})
    joints_->advance(std::min(secondsBetween(lastStep_, now), kMost));
  lastStep_ = now;
  if (stream_.hasFallenSilent(now)) {
    stream_.end();
    hold();
  }
  if (feedback_.power == DrivePower::On) {
    joints_->order(order_);
    joints_->command(goal_);
  } else {
    hold();  // where the joints are now, which may not be where they were when the power went
    joints_->brake();
  }
  Joints::Map(feedback_.position.data()) = coupling_.actuators(joints_->measured());
  Joints::Map(feedback_.velocity.data()) = coupling_.actuators(joints_->velocity());
  Joints::Map(feedback_.effort.data()) = coupling_.actuatorEfforts(joints_->effort());
  feedback_.stamp = now;
}

template <int N>
void SimulatedDrives<N>::hold() {
  goal_ = joints_->measured();
  order_ = {.compensation = order_.compensation};
}

template <int N>
void SimulatedDrives<N>::enter(DrivePower power) {
  stream_.end();
  hold();
  feedback_.power = power;
  powerChanged_ = true;
}

template class SimulatedDrives<6>;
template class SimulatedDrives<7>;
template class SimulatedDrives<8>;

}  // namespace robots
