#pragma once
// The teleoperation law: how a slave follows a master.

#include <Eigen/Geometry>
#include <cmath>

namespace robots {

/// x_s = x_s0 + s (x_m - x_m0), R_s = R_m A with A = R_m0^T R_s0: translation relative to where
/// following began and scaled, orientation rigidly coupled. The law of the da Vinci Research Kit
/// (sawIntuitiveResearchKit, mtsTeleOperationPSM). Immutable; no method allocates or throws.
class FollowLaw {
 public:
  /// Anchors at the entry to following: `master` is the master's measured pose, `slaveSetpoint` the
  /// slave's set-point (not its measured pose, or the tracking error of that moment would become a
  /// step). Each in its own arm's base frame, m. The scale must be valid.
  FollowLaw(const Eigen::Isometry3d& master, const Eigen::Isometry3d& slaveSetpoint, double scale)
      : master0_(master.translation()),
        slave0_(slaveSetpoint.translation()),
        alignment_(master.linear().transpose() * slaveSetpoint.linear()),
        scale_(scale) {}

  /// True for a finite scale above zero: a mirrored or frozen slave is a mistake, not a setting.
  static bool isValidScale(double scale) { return std::isfinite(scale) && scale > 0; }

  /// Where the slave shall be (its base frame, m) while the master is at `master`.
  Eigen::Isometry3d follow(const Eigen::Isometry3d& master) const {
    Eigen::Isometry3d slave = Eigen::Isometry3d::Identity();
    slave.translation() = slave0_ + scale_ * (master.translation() - master0_);
    slave.linear() = master.linear() * alignment_;
    return slave;
  }

 private:
  Eigen::Vector3d master0_;
  Eigen::Vector3d slave0_;
  Eigen::Matrix3d alignment_;
  double scale_;
};

}  // namespace robots
