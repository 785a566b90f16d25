#include "kinematics/psm_inverse.h"

#include <cmath>

#include "kinematics/candidates.h"
#include "kinematics/davinci_links.h"

namespace robots::kinematics {
namespace {

using Eigen::Vector3d;
using PsmJoints = Chain<6>::Joints;

Vector3d across(const Vector3d& axis, const Vector3d& vector) {
  return vector - vector.dot(axis) * axis;
}

// Returns the unit vector across `axis` toward `wanted`; toward `otherwise` if `wanted` lies along
// the axis, and any unit vector across it if both do.
Vector3d directionAcross(const Vector3d& axis, const Vector3d& wanted, const Vector3d& otherwise) {
  Vector3d direction = across(axis, wanted);
  if (direction.norm() <= kOpenLength) direction = across(axis, otherwise);
  if (direction.norm() <= kOpenLength) return axis.unitOrthogonal();
  // The rounding error of across() lies along the axis and grows with the whole vector, so it may
  // be large beside a short part. The second call takes it off.
  return across(axis, direction.normalized()).normalized();
}

// The goal places the instrument so in the base. The tip's frame has x against the axis of the
// wrist yaw, and y against x of that joint's frame (davinci.cpp).
struct Instrument {
  Vector3d tip;
  Vector3d yawAxis;  // the wrist yaws about it
  Vector3d jaws;     // x of the frame behind the wrist yaw

  explicit Instrument(const Eigen::Isometry3d& goal)
      : tip(goal.translation()), yawAxis(-goal.linear().col(0)), jaws(-goal.linear().col(1)) {}
};

// This is the link between the two axes of the wrist.
struct Wrist {
  Vector3d link;       // unit vector from the axis of the wrist pitch to that of the wrist yaw
  Vector3d pitchAxis;  // unit vector across the link and the yaw axis
  Vector3d centre;     // m, on the pitch axis, where the shaft ends
};

Wrist wristAlong(const Vector3d& link, const Instrument& instrument) {
  return {link, link.cross(instrument.yawAxis), instrument.tip - kPsmWrist * link};
}

// Returns the joints for a wrist that is held by a shaft in the direction of the unit vector
// `shaft`, which is across the pitch axis.
PsmJoints jointsFor(const Chain<6>& chain, const Instrument& instrument, const Wrist& wrist,
                    const Vector3d& shaft, const PsmJoints& start) {
  PsmJoints q = PsmJoints::Zero();
  q[0] = std::atan2(shaft.x(), -shaft.z());
  q[1] = std::atan2(-shaft.y(), std::hypot(shaft.x(), shaft.z()));
  q[2] = wrist.centre.dot(shaft) + kPsmCarriage - kPsmShaft;
  const Vector3d pitchAxis = chain.link(q, 3).linear().transpose() * wrist.pitchAxis;
  q[3] = std::atan2(-pitchAxis.x(), pitchAxis.y());
  q[4] = std::atan2(-shaft.dot(instrument.yawAxis), shaft.dot(wrist.link));
  q[5] = std::atan2(instrument.jaws.dot(wrist.link), instrument.jaws.dot(wrist.pitchAxis));
  for (const int turns : {0, 3, 4, 5}) {
    q[turns] = nearestTurn(q[turns], start[turns], chain.lower()[turns], chain.upper()[turns]);
  }
  return q;
}

}  // namespace

InverseSolution<6> psmInverse(const Chain<6>& chain, const Eigen::Isometry3d& goal,
                              const PsmJoints& start, Postures postures) {
  Candidates<6> candidates(chain, start, postures);
  if (!goal.matrix().allFinite()) return candidates.choose(goal, false);
  const Instrument instrument(goal);
  const Eigen::Matrix3d before = chain.link(start, 5).linear();
  const Vector3d shaftBefore =
      std::cos(start[4]) * before.col(0) - std::sin(start[4]) * before.col(1);
  // The shaft meets the pitch axis at a right angle and leads through the remote centre, so that
  // the link lies in the plane of the yaw axis and the remote centre.
  const Vector3d link = directionAcross(instrument.yawAxis, instrument.tip, before.col(0));
  for (const double side : {1.0, -1.0}) {
    const Wrist wrist = wristAlong(side * link, instrument);
    const Vector3d shaft = directionAcross(wrist.pitchAxis, wrist.centre, shaftBefore);
    for (const double sense : {1.0, -1.0}) {
      candidates.add(jointsFor(chain, instrument, wrist, sense * shaft, start));
    }
  }
  return candidates.choose(goal, true);
}

}  // namespace robots::kinematics
