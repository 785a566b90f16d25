#include "kinematics/chain.h"

#include <cmath>

namespace robots::kinematics {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

Isometry3d alongX(double a, double alpha) {
  return Translation3d(a, 0, 0) * AngleAxisd(alpha, Vector3d::UnitX());
}

Isometry3d alongZ(double d, double theta) {
  return Translation3d(0, 0, d) * AngleAxisd(theta, Vector3d::UnitZ());
}

// Returns frame * motion(q), where the motion is about or along z of the frame. Only two columns of
// a rotation change, and this is most of what forward kinematics costs.
Isometry3d moved(Isometry3d frame, JointKind kind, double q) {
  if (kind == JointKind::Prismatic) {
    frame.translation() += q * frame.linear().col(2);
    return frame;
  }
  const double sine = std::sin(q), cosine = std::cos(q);
  const Vector3d x = frame.linear().col(0), y = frame.linear().col(1);
  frame.linear().col(0) = cosine * x + sine * y;
  frame.linear().col(1) = cosine * y - sine * x;
  return frame;
}

// Returns the part along z that does not depend on the joint.
Isometry3d constantZ(const Link& link) {
  return link.kind == JointKind::Revolute ? alongZ(link.d, link.offset) : alongZ(link.offset, 0);
}

}  // namespace

template <int N>
Chain<N>::Chain(Convention convention, const std::array<Link, std::size_t{N}>& links,
                const Isometry3d& tip) {
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Link& link = links[i];
    const Isometry3d x = alongX(link.a, link.alpha);
    const Isometry3d z = constantZ(link);
    const Isometry3d none = Isometry3d::Identity();
    if (convention == Convention::Standard) {
      segments_[i] = {none, z * x, none, link.kind};
    } else {
      segments_[i] = {x, z, none, link.kind};
    }
    lower_[static_cast<Eigen::Index>(i)] = link.lower;
    upper_[static_cast<Eigen::Index>(i)] = link.upper;
  }
  segments_.back().after = segments_.back().after * tip;
  segments_.back().toNext = segments_.back().after;
  for (std::size_t i = 0; i + 1 < links.size(); ++i) {
    segments_[i].toNext = segments_[i].after * segments_[i + 1].before;
  }
}

template <int N>
Isometry3d Chain<N>::beyond(const Isometry3d& joint, const Joints& q, int i) const {
  const Segment& segment = segments_[static_cast<std::size_t>(i)];
  return moved(joint, segment.kind, q[i]) * segment.toNext;
}

template <int N>
Isometry3d Chain<N>::forward(const Joints& q) const {
  Isometry3d tip = segments_.front().before;
  for (int i = 0; i < N; ++i) tip = beyond(tip, q, i);
  return tip;
}

template <int N>
Isometry3d Chain<N>::link(const Joints& q, int joints) const {
  if (joints == 0) return Isometry3d::Identity();
  Isometry3d frame = segments_.front().before;
  for (int i = 0; i + 1 < joints; ++i) frame = beyond(frame, q, i);
  const Segment& last = segments_[static_cast<std::size_t>(joints - 1)];
  return moved(frame, last.kind, q[joints - 1]) * last.after;
}

template <int N>
Isometry3d Chain<N>::relative(int joint, double q) const {
  const Segment& segment = segments_[static_cast<std::size_t>(joint)];
  return moved(segment.before, segment.kind, q) * segment.after;
}

template <int N>
SpatialVector Chain<N>::screw(int joint) const {
  const Segment& segment = segments_[static_cast<std::size_t>(joint)];
  const Vector3d axis = segment.after.linear().row(2).transpose();
  SpatialVector screw = SpatialVector::Zero();
  if (segment.kind == JointKind::Prismatic) {
    screw.head<3>() = axis;
  } else {
    const Vector3d fromAxis = segment.after.linear().transpose() * segment.after.translation();
    screw << axis.cross(fromAxis), axis;
  }
  return screw;
}

template <int N>
typename Chain<N>::Posture Chain<N>::posture(const Joints& q) const {
  std::array<Isometry3d, std::size_t{N}> joints;
  Isometry3d tip = segments_.front().before;
  for (int i = 0; i < N; ++i) {
    joints[static_cast<std::size_t>(i)] = tip;
    tip = beyond(tip, q, i);
  }
  Jacobian jacobian;
  for (int i = 0; i < N; ++i) {
    const Isometry3d& joint = joints[static_cast<std::size_t>(i)];
    const Vector3d axis = joint.linear().col(2);
    if (segments_[static_cast<std::size_t>(i)].kind == JointKind::Revolute) {
      jacobian.col(i) << axis.cross(tip.translation() - joint.translation()), axis;
    } else {
      jacobian.col(i) << axis, Vector3d::Zero();
    }
  }
  return {tip, jacobian};
}

template class Chain<6>;
template class Chain<7>;

}  // namespace robots::kinematics
