#pragma once
// This is one rigid body, and how its inertia moves between frames.

#include <Eigen/Geometry>

#include "kinematics/spatial_vector.h"

namespace robots::dynamics {

using kinematics::SpatialVector;

/// Says what a link weighs, in the axes of its own frame (Chain::link; the frame of the last link
/// is the tool tip's).
struct LinkInertia {
  double mass;              ///< kg
  Eigen::Vector3d centre;   ///< m: the centre of mass
  Eigen::Matrix3d inertia;  ///< kg.m^2: about the centre of mass
  double rotor;  ///< kg.m^2, or kg for a prismatic joint: what the motor adds, seen from the joint
};

/// A BodyInertia is a LinkInertia, or several that do not move against each other, about the origin
/// of a frame.
struct BodyInertia {
  double mass = 0;                                         ///< kg
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();        ///< kg.m: mass by centre of mass
  Eigen::Matrix3d about_origin = Eigen::Matrix3d::Zero();  ///< kg.m^2
};

/// Returns the matrix whose product with x is `v.cross(x)`.
inline Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

inline BodyInertia aboutOrigin(const LinkInertia& link) {
  const Eigen::Matrix3d centre = crossMatrix(link.centre);
  return {link.mass, link.mass * link.centre, link.inertia - link.mass * centre * centre};
}

/// Returns the same body, seen from the frame in which `frame` is given.
inline BodyInertia movedTo(const Eigen::Isometry3d& frame, const BodyInertia& body) {
  const Eigen::Vector3d& p = frame.translation();
  const Eigen::Matrix3d& r = frame.linear();
  const Eigen::Vector3d turned = r * body.moment;
  const Eigen::Vector3d moment = turned + body.mass * p;
  return {body.mass, moment,
          r * body.about_origin * r.transpose() - crossMatrix(p) * crossMatrix(turned) -
              crossMatrix(moment) * crossMatrix(p)};
}

inline BodyInertia operator+(const BodyInertia& a, const BodyInertia& b) {
  return {a.mass + b.mass, a.moment + b.moment, a.about_origin + b.about_origin};
}

/// Returns the momentum (N.s, N.m.s) of a body that moves with `twist`; if that is an acceleration,
/// the wrench.
inline SpatialVector momentum(const BodyInertia& body, const SpatialVector& twist) {
  const Eigen::Vector3d linear = twist.head<3>(), angular = twist.tail<3>();
  SpatialVector result;
  result << body.mass * linear + angular.cross(body.moment),
      body.about_origin * angular + body.moment.cross(linear);
  return result;
}

/// Returns how `other`, a twist that is at rest in a frame which moves with `twist`, changes.
inline SpatialVector crossMotion(const SpatialVector& twist, const SpatialVector& other) {
  const Eigen::Vector3d linear = twist.head<3>(), angular = twist.tail<3>();
  SpatialVector result;
  result << angular.cross(other.head<3>()) + linear.cross(other.tail<3>()),
      angular.cross(other.tail<3>());
  return result;
}

/// Returns how a momentum that is at rest in a frame which moves with `twist` changes.
inline SpatialVector crossForce(const SpatialVector& twist, const SpatialVector& momentum) {
  const Eigen::Vector3d linear = twist.head<3>(), angular = twist.tail<3>();
  SpatialVector result;
  result << angular.cross(momentum.head<3>()),
      angular.cross(momentum.tail<3>()) + linear.cross(momentum.head<3>());
  return result;
}

/// Returns a twist of the frame in which `frame` is given, as it is at `frame` and along its axes.
inline SpatialVector twistAt(const Eigen::Isometry3d& frame, const SpatialVector& twist) {
  const Eigen::Vector3d linear = twist.head<3>(), angular = twist.tail<3>();
  SpatialVector result;
  result << frame.linear().transpose() * (linear + angular.cross(frame.translation())),
      frame.linear().transpose() * angular;
  return result;
}

/// Returns a wrench at `frame`, as it is in the frame in which `frame` is given.
inline SpatialVector wrenchFrom(const Eigen::Isometry3d& frame, const SpatialVector& wrench) {
  const SpatialVector turned = kinematics::rotated(frame.linear(), wrench);
  SpatialVector result = turned;
  result.tail<3>() += frame.translation().cross(turned.head<3>());
  return result;
}

}  // namespace robots::dynamics
