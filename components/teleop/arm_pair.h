#pragma once
// This is a master and the slave that it drives, as the task between them sees them.

#include <suture/base/time.h>
#include <suture/component/required.h>

#include <optional>

#include "arm/arm.suture.h"
#include "arm/arm_watch.h"
#include "arm/fresh_pose.h"
#include "robot_types/pose.h"

namespace robots {

/// Are where a master is, and where its slave was sent.
struct ArmPoses {
  PoseStamped master, slave;
};

/// Says what to do about a slave that refuses() its goals.
inline constexpr const char* kGoalsRefused =
    "a slave refuses its goals; look at its warnings, insert its tool, then enable";
/// Says what to do about arms that are not ready in time.
inline constexpr const char* kNotReadyInTime =
    "the arms have not become ready in time; enable those in FAULT, then this";

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
    const auto masterSample = master_.measured_cp();
    const auto slaveSample = slave_.setpoint_cp();
    const PoseStamped* const master = freshMeasurement(masterSample, maxAge);
    const PoseStamped* const slave = freshPose(slaveSample, maxAge);
    if (master == nullptr || slave == nullptr) return std::nullopt;
    return ArmPoses{*master, *slave};
  }
  /// Lets the slave hold where it is. Does not disturb others who move one that is not ready.
  void holdSlave() {
    if (slaveWatch_.ready()) (void)slave_.hold();
  }

 private:
  suture::Required<Arm>&master_, &slave_;
  ArmWatch masterWatch_, slaveWatch_;
};

}  // namespace robots
