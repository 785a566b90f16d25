#include "drives/simulated_drives.h"

#include "timing/seconds.h"

namespace robots {

template <int N>
SimulatedDrives<N>::SimulatedDrives(const DriveModel<N>& model)
    : dynamics_(model.time_constant, model.rate_limit, model.lower, model.upper, model.parked),
      goal_(dynamics_.measured()) {
  static_assert(N <= int{kMaxJoints});
  feedback_.joints = N;
}

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
  const Joints q = Joints::Map(goal.position.data());
  if (feedback_.power != DrivePower::On || goal.joints != N || !q.allFinite()) return;
  goal_ = q;
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
  dynamics_.command(goal_);
}

template <int N>
void SimulatedDrives<N>::step(suture::Time now) {
  if (lastStep_ != suture::Time{}) dynamics_.advance(secondsBetween(lastStep_, now));
  lastStep_ = now;
  if (stream_.hasFallenSilent(now)) {
    stream_.end();
    hold();
  }
  if (feedback_.power != DrivePower::On) hold();  // where they are now, not when that was decided
  dynamics_.command(goal_);
  Joints::Map(feedback_.position.data()) = dynamics_.measured();
  Joints::Map(feedback_.velocity.data()) = dynamics_.velocity();
  feedback_.stamp = now;
}

template <int N>
void SimulatedDrives<N>::enter(DrivePower power) {
  stream_.end();
  feedback_.power = power;
  powerChanged_ = true;
}

template class SimulatedDrives<6>;
template class SimulatedDrives<7>;

}  // namespace robots
