#pragma once
// This is one master of the guide, the slave that it drives, and how it does so.

#include <suture/base/time.h>
#include <suture/component/required.h>

#include <Eigen/Geometry>
#include <optional>

#include "arm/arm.suture.h"
#include "force_feedback/fixture_resistance.h"
#include "guidance/joint_room.h"
#include "robot_types/cartesian.h"
#include "robot_types/joints.h"
#include "teleop/arm_pair.h"
#include "teleop/follow_law.h"

namespace robots {

/// Belongs to the guide's thread. Bases are those of the slave in the scene, and tips are in the
/// scene, m.
class GuidedSide {
 public:
  struct Settings {
    double scale = 1;           // m of the slave for each of the master
    double master_damping = 0;  // N.s/m; with 0 the master gets no forces
    double period = 0.001;      // s
  };

  GuidedSide(suture::Component& guide, const char* masterName, const char* slaveName,
             const Settings& settings);

  /// Returns false unless the data of both arms may be acted on in this cycle.
  bool readArms(suture::Duration maxAge, bool withJoints);
  /// Says in which directions the surgeon sees the slave. With another view it goes on from where
  /// the last cycle led it, because a camera that moves must not move the slave.
  void look(const Eigen::Matrix3d& view);
  /// Lets the slave follow from where it is.
  void begin();
  /// Ends following; the slave may be another one when it goes on.
  void end();
  /// Lets it begin anew, because the slave is elsewhere in the scene.
  void forgetAnchor() { law_.reset(); }
  bool follows() const { return law_.has_value(); }

  /// Returns where the law leads the slave, whose tip has been sent to `tip`, with the tool turned
  /// only as far as the joints have room for.
  Eigen::Isometry3d goal(const Eigen::Isometry3d& base, const Eigen::Vector3d& tip) const;
  /// Returns the room of a step from `tip` that also turns the tool as `goal` is.
  JointRoom room(const Eigen::Isometry3d& goal, const Eigen::Isometry3d& base,
                 const Eigen::Vector3d& tip) const;
  /// Sends the slave `goal` with its tip moved to `tip`. The goal keeps the stamp of the master's
  /// data, so that its age is known wherever it arrives. Returns false if the slave did not take
  /// it.
  bool send(const Eigen::Isometry3d& goal, const Eigen::Isometry3d& base,
            const Eigen::Vector3d& tip);
  /// Forgets so much, in m in the scene, of what the master has asked for.
  void forget(const Eigen::Vector3d& wish, const Eigen::Isometry3d& base);
  /// Lets the master press against its hand, which leads the tip with `forbidden` m/s in the scene
  /// where the fixtures let it not go.
  void resist(const Eigen::Vector3d& forbidden, const Eigen::Isometry3d& base);
  /// Lets the master float in its hand.
  void release();

  ArmPair& arms() { return arms_; }
  const ArmPoses& poses() const { return poses_; }

 private:
  void readJoints(suture::Duration maxAge);
  TipAhead ahead(const Eigen::Isometry3d& goal, const Eigen::Isometry3d& base,
                 const Eigen::Vector3d& tip) const;
  void anchor(const Eigen::Isometry3d& slaveSetpoint);
  void press(const Eigen::Vector3d& force);

  const Settings settings_;
  suture::Required<Arm> master_, slave_;
  ArmPair arms_{master_, slave_};
  Eigen::Matrix3d view_ = Eigen::Matrix3d::Identity();
  std::optional<FollowLaw> law_;
  ArmPoses poses_;                    // of this cycle
  Eigen::Matrix3d turned_;            // how the tool has been sent to turn
  JointConfiguration configuration_;  // these three keep their memory
  JointState setpointJs_;
  Jacobian jacobian_;
  Eigen::Matrix3d mount_ = Eigen::Matrix3d::Identity();  // turns its base's axes to its poses'
  std::optional<JointBounds> bounds_;
  bool knowsJoints_ = false;  // in this cycle
  FixtureResistance resistance_;
  bool presses_ = false;  // the master, and the account of its energy has begun
};

}  // namespace robots
