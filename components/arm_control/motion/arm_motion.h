#pragma once
// This is what an arm tells of how it moves.

#include <suture/base/time.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "arm_control/drive_reading.h"
#include "robot_types/joints.h"
#include "robot_types/pose.h"

namespace robots {

/// One thread. Keeps the measurement and the set-point as the contract of an arm returns them, in
/// joints and as poses of the tip in the base frame. Only the constructor allocates.
template <int N>
class ArmMotion {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  explicit ArmMotion(const std::array<const char*, std::size_t{N}>& names) {
    for (JointState* const joints : {&measuredJs_, &setpointJs_}) {
      joints->name.assign(names.begin(), names.end());
      joints->position.resize(N);
    }
    measuredJs_.velocity.resize(N);
    measuredJs_.effort.resize(N);
  }

  const JointState& measured_js() const { return measuredJs_; }
  const JointState& setpoint_js() const { return setpointJs_; }
  const PoseStamped& measured_cp() const { return measuredCp_; }
  const PoseStamped& setpoint_cp() const { return setpointCp_; }

  void setMeasured(const DriveReading<N>& drives, const Eigen::Isometry3d& tip, bool valid) {
    place(measuredJs_, drives.position, drives.stamp, valid);
    Joints::Map(measuredJs_.velocity.data()) = drives.velocity;
    measuredJs_.effort.resize(drives.measures_effort ? N : 0);
    std::copy_n(drives.effort.data(), measuredJs_.effort.size(), measuredJs_.effort.begin());
    measuredCp_ = {tip, drives.stamp, valid};
  }
  /// The joints' set-point is stamped `now`; the tip's has the stamp of the goal it came from.
  void setSetpoint(const Joints& joints, suture::Time now, const Eigen::Isometry3d& tip,
                   suture::Time goalStamp, bool valid) {
    place(setpointJs_, joints, now, valid);
    setpointCp_ = {tip, goalStamp, valid};
  }

 private:
  static void place(JointState& state, const Joints& position, suture::Time stamp, bool valid) {
    std::copy_n(position.data(), N, state.position.begin());
    state.stamp = stamp;
    state.valid = valid;
  }

  JointState measuredJs_, setpointJs_;
  PoseStamped measuredCp_, setpointCp_;
};

}  // namespace robots
