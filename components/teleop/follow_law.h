#pragma once
// This is the teleoperation law, by which a slave follows a master.

#include <Eigen/Geometry>
#include <cmath>

namespace robots {

struct FollowSettings {
  /// The slave moves this many metres for each metre of the master.
  double scale = 1;
  /// Rotates directions of the master's reference frame to those of the slave's that look the same
  /// to the surgeon.
  Eigen::Matrix3d view = Eigen::Matrix3d::Identity();
  /// If one of these is true, the slave keeps its orientation or its position, whatever the master
  /// does.
  bool rotation_locked = false;
  bool translation_locked = false;
};

/// No method allocates or throws. The law is x_s = x_s0 + s V (x_m - x_m0), R_s = V R_m
/// A with A = (V R_m0)^T R_s0: translation is relative to where following began and scaled,
/// orientation is rigidly coupled, both as they look in the view V. It is the law of the da Vinci
/// Research Kit (sawIntuitiveResearchKit, mtsTeleOperationPSM).
class FollowLaw {
 public:
  /// Takes the anchors at the entry to following: `master` is the master's measured pose,
  /// `slaveSetpoint` the slave's set-point (not its measured pose, or the tracking error of that
  /// moment would become a step). Each is in its own arm's reference frame, in m. The scale must be
  /// valid.
  FollowLaw(const Eigen::Isometry3d& master, const Eigen::Isometry3d& slaveSetpoint,
            const FollowSettings& settings)
      : settings_(settings),
        master0_(master.translation()),
        slave0_(slaveSetpoint),
        alignment_((settings.view * master.linear()).transpose() * slaveSetpoint.linear()) {}

  /// Returns true for a finite scale above zero, because a mirrored or frozen slave is a mistake,
  /// not a setting.
  static bool isValidScale(double scale) { return std::isfinite(scale) && scale > 0; }

  const FollowSettings& settings() const { return settings_; }

  /// Leads the slave from now on so far away from where it would have led it (its reference frame,
  /// m).
  void shift(const Eigen::Vector3d& by) { slave0_.translation() += by; }

  /// Returns where the slave shall be (its reference frame, m) while the master is at `master`.
  Eigen::Isometry3d follow(const Eigen::Isometry3d& master) const {
    Eigen::Isometry3d slave = slave0_;
    if (!settings_.translation_locked) {
      slave.translation() += settings_.scale * settings_.view * (master.translation() - master0_);
    }
    if (!settings_.rotation_locked) {
      slave.linear() = settings_.view * master.linear() * alignment_;
    }
    return slave;
  }

 private:
  FollowSettings settings_;
  Eigen::Vector3d master0_;
  Eigen::Isometry3d slave0_;
  Eigen::Matrix3d alignment_;
};

}  // namespace robots
