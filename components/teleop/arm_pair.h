#pragma once
// This is a master and the slave that it drives, as the task between them sees them.

#include <suture/base/time.h>
#include <suture/component/read_together.h>
#include <suture/component/required.h>

#include <Eigen/Geometry>
#include <optional>
#include <tuple>

#include "arm/arm.suture.h"
#include "arm/arm_watch.h"
#include "arm/fresh_pose.h"
#include "robot_types/pose.h"

namespace robots {

/// ArmPoses say where a master is, and where its slave was sent.
struct ArmPoses {
  PoseStamped master, slave;
  /// The master's poses refer to another base than those before, so that it seems to have moved.
  bool rebased = false;
};

/// Says what to do about a slave that refuses() its goals.
inline constexpr const char* kGoalsRefused =
    "a slave refuses its goals; look at its warnings, insert its tool, then enable";
/// Says what to do about arms that are not ready in time.
inline constexpr const char* kNotReadyInTime =
    "the arms have not become ready in time; enable those in FAULT, then this";
/// Says what to do about a slave that does not carry out goals in time.
inline constexpr const char* kGoalsNotTaken =
    "a slave carries out no goal; look at its warnings, and if goals reach it within their 20 ms";

/// Belongs to the thread of the component that owns both required interfaces, which has it as a
/// member declared after them.
class ArmPair {
 public:
  ArmPair(suture::Required<Arm>& master, suture::Required<Arm>& slave)
      : master_(master), slave_(slave), masterWatch_(master), slaveWatch_(slave) {}

  ArmWatch& master() { return masterWatch_; }
  ArmWatch& slave() { return slaveWatch_; }
  bool ready() const { return masterWatch_.ready() && slaveWatch_.ready(); }

  /// Call this once a cycle. Makes both arms ready, as ArmWatch does.
  void prepare() {
    masterWatch_.prepare();
    slaveWatch_.prepare();
  }
  /// Lets prepare() ask again, which an operator must have decided.
  void permit() {
    masterWatch_.permit();
    slaveWatch_.permit();
  }
  /// Ends what prepare() began and is still under way, before nobody watches it any more.
  void stopPreparing() {
    masterWatch_.stopHoming();
    slaveWatch_.stopHoming();
  }
  /// Returns both poses; none if either may not be acted on, or is older than `maxAge`.
  std::optional<ArmPoses> poses(suture::Duration maxAge) {
    // Both come from one row, so that no pose is judged by an earlier base.
    const auto row = suture::readTogether(master_.measured_cp, master_.base_frame);
    if (!row) return std::nullopt;
    const suture::Sample<PoseStamped> masterSample(std::get<PoseStamped>(*row), row.stamp());
    const auto slaveSample = slave_.setpoint_cp();
    const PoseStamped* const master = freshMeasurement(masterSample, maxAge);
    const PoseStamped* const slave = freshPose(slaveSample, maxAge);
    if (master == nullptr || slave == nullptr) return std::nullopt;
    const Eigen::Isometry3d& base = std::get<TransformStamped>(*row).transform;
    const bool rebased = base_ && base_->matrix() != base.matrix();
    base_ = base;
    return ArmPoses{*master, *slave, rebased};
  }
  /// Lets the slave hold where it is, if it is ready. One that is not may be moved by others.
  void holdSlave() {
    if (slaveWatch_.ready()) slaveWatch_.hold();
  }

 private:
  suture::Required<Arm>&master_, &slave_;
  ArmWatch masterWatch_, slaveWatch_;
  std::optional<Eigen::Isometry3d> base_;  // where the master stands
};

}  // namespace robots
