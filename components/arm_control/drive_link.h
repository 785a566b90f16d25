#pragma once
// This is the arm's side of its drives.

#include <suture/base/time.h>
#include <suture/component/required.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>

#include "arm_control/drive_reading.h"
#include "drives/coupling.h"
#include "drives/drives.suture.h"
#include "drives/motor_order.h"
#include "timing/cycle_watch.h"

namespace robots {

/// Belongs to the thread of the component that owns the required interface, which has it as a
/// member declared after that interface. Reads what the drives behind it measure, and tells them
/// what to do.
template <int N>
class DriveLink {
 public:
  using Joints = typename DriveReading<N>::Joints;

  /// `coupling` is that of the actuators, and of the tool's behind them, with the joints.
  explicit DriveLink(suture::Required<Drives>& drives, const Coupling<N + 1>& coupling = {})
      : drives_(drives), coupling_(coupling) {
    goal_.joints = kChannels;
  }
  DriveLink(const DriveLink&) = delete;
  DriveLink& operator=(const DriveLink&) = delete;

  /// Call this once a cycle. Returns what the drives measured last; none if they have measured
  /// nothing new for too long while the arm looked.
  std::optional<DriveReading<N>> read() {
    const auto sample = drives_.feedback();
    const suture::Time now = suture::now();
    if (cycles_.missed(kSilence)) heard_ = now;
    if (sample && sample->joints == kChannels && sample->stamp != last_.stamp) {
      heard_ = now;
      last_ = ofJoints(*sample);
    }
    isHeard_ = last_.stamp != suture::Time{} && now - heard_ <= kSilence;
    return isHeard_ ? std::optional(last_) : std::nullopt;
  }

  /// Call this once a cycle, after read(). Asks for power again until it is there, because a
  /// command may be lost. Drives that are silent get no goals, because the arm does not know where
  /// their joints are. `tool` is where the tool shall be, in rad.
  void command(bool powered, const Joints& setpoint, const MotorOrder<N>& order, double tool) {
    if (powered && last_.power == DrivePower::Off) (void)drives_.power_on(last_.permitted);
    if (!powered && last_.power == DrivePower::On) (void)drives_.power_off();
    if (!powered || !isHeard_) return;
    All joints, efforts;
    joints << setpoint, tool;
    efforts << order.effort, 0;
    All::Map(goal_.position.data()) = coupling_.actuators(joints);
    All::Map(goal_.effort.data()) = coupling_.actuatorEfforts(efforts);
    std::copy_n(order.released.data(), N, goal_.released.begin());
    goal_.gravity_compensation = order.compensation;
    (void)drives_.servo_jp(goal_);
  }

 private:
  using All = typename Coupling<N + 1>::Vector;

  DriveReading<N> ofJoints(const DriveFeedback& told) const {
    const All position = coupling_.joints(All::Map(told.position.data()));
    const All velocity = coupling_.joints(All::Map(told.velocity.data()));
    const All effort = coupling_.jointEfforts(All::Map(told.effort.data()));
    return {.position = position.template head<N>(),
            .velocity = velocity.template head<N>(),
            .power = told.power,
            .permitted = told.permitted,
            .stamp = told.stamp,
            .tool = {.position = position[N], .velocity = velocity[N], .effort = effort[N]},
            .effort = effort.template head<N>(),
            .measures_effort = told.measures_effort,
            .controls_effort = told.controls_effort};
  }

  static constexpr std::uint32_t kChannels = N + 1;  // the last is that of the tool
  static_assert(kChannels <= kMaxJoints);
  static constexpr suture::Duration kSilence = std::chrono::milliseconds(250);

  suture::Required<Drives>& drives_;
  const Coupling<N + 1> coupling_;
  CycleWatch cycles_;
  DriveReading<N> last_;
  suture::Time heard_;  // when `last_` was new, or the arm began to look again
  bool isHeard_ = false;
  DriveGoal goal_;
};

}  // namespace robots
