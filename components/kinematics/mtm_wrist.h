#pragma once
// These are the four joints of a master's gimbal, which turn about one point.

#include <optional>

#include "kinematics/chain.h"

namespace robots::kinematics {

/// Finds platform, wrist pitch, wrist yaw and roll (joints 4 to 7 of mtmLeft() and mtmRight()) that
/// give the tool one orientation: three of them follow in closed form from the platform. Chain and
/// start are kept by reference; they have all seven joints, in rad. Never allocates.
class MtmWrist {
 public:
  using Joints = Eigen::Vector4d;

  /// `orientation` is that of the tool in the frame behind the elbow.
  MtmWrist(const Chain<7>& chain, const Eigen::Matrix3d& orientation,
           const Chain<7>::Joints& start);

  /// Returns the four joints with the platform at this angle, the others on the turn within their
  /// limits that is nearest to the start; they may lie beyond their limits. The posture with the
  /// cosine of the wrist yaw below zero is left out, because no limits admit it.
  Joints at(double platform) const;

  /// Returns the joints within their limits that are nearest to the start, downhill from the
  /// admissible platform angle nearest to the start's, in at most eight steps. There are none if
  /// the limits admit no platform angle.
  std::optional<Joints> nearest() const;

 private:
  /// This is a range of platform angles.
  struct Range {
    double lower, upper;
  };
  class Boundaries;

  Boundaries boundaries() const;
  double platformForRoll(double roll) const;
  std::optional<Range> nearestRange() const;
  bool isWithin(const Joints& q) const;

  const Chain<7>& chain_;
  const Chain<7>::Joints& start_;
  Eigen::Matrix3d orientation_;
  double heading_;  // rad: of the roll axis about the platform's
  double tilt_;     // sine of the angle between the two
  double height_;   // its cosine
};

}  // namespace robots::kinematics
