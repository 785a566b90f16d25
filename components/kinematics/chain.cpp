#include "kinematics/chain.h"

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

Isometry3d motion(JointKind kind, double q) {
  return kind == JointKind::Revolute ? alongZ(0, q) : alongZ(q, 0);
}

// The part along z that does not depend on the joint.
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
    if (convention == Convention::Standard) {
      segments_[i] = {Isometry3d::Identity(), z * x, link.kind};
    } else {
      segments_[i] = {x, z, link.kind};
    }
    lower_[static_cast<Eigen::Index>(i)] = link.lower;
    upper_[static_cast<Eigen::Index>(i)] = link.upper;
  }
  segments_.back().after = segments_.back().after * tip;
}

template <int N>
Isometry3d Chain<N>::forward(const Joints& q) const {
  return link(q, N);
}

template <int N>
Isometry3d Chain<N>::link(const Joints& q, int joints) const {
  Isometry3d tip = Isometry3d::Identity();
  for (int i = 0; i < joints; ++i) {
    const Segment& segment = segments_[static_cast<std::size_t>(i)];
    tip = tip * segment.before * motion(segment.kind, q[i]) * segment.after;
  }
  return tip;
}

template <int N>
typename Chain<N>::Jacobian Chain<N>::jacobian(const Joints& q) const {
  std::array<Isometry3d, std::size_t{N}> joints;
  Isometry3d tip = Isometry3d::Identity();
  for (int i = 0; i < N; ++i) {
    const Segment& segment = segments_[static_cast<std::size_t>(i)];
    joints[static_cast<std::size_t>(i)] = tip * segment.before;
    tip = joints[static_cast<std::size_t>(i)] * motion(segment.kind, q[i]) * segment.after;
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
  return jacobian;
}

template class Chain<6>;
template class Chain<7>;

}  // namespace robots::kinematics
