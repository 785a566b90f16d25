#include "guidance/fixtures.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace robots {
namespace {

using Eigen::Vector3d;

// The last tenths of a millimetre need a minimum speed, or the knot would never arrive.
constexpr double kCreep = 0.0005;  // m/s

}  // namespace

/// Holds the rows as they are added. Each says that its product with the steps is at least its
/// bound. No bound is above zero, so that standing still is permitted, whatever has happened.
struct KnotFixtures::Constraints {
  Program::Rows rows = Program::Rows::Zero();
  Program::Bounds bounds = Program::Bounds::Zero();
  int count = 0;

  void require(const Vector3d& left, const Vector3d& right, double atLeast) {
    rows.row(count) << left.transpose(), right.transpose();
    bounds[count++] = std::min(atLeast, 0.0);
  }
  /// Does the same for the mean of both steps.
  void requireOfMean(const Vector3d& direction, double atLeast) {
    require(direction / 2, direction / 2, atLeast);
  }
};

KnotFixtures::KnotFixtures(const FixtureModel& model) : model_(model) {
  model_.approach.normalize();
  across_[0] = model_.approach.unitOrthogonal();
  across_[1] = model_.approach.cross(across_[0]);
}

double KnotFixtures::distanceToTarget(const Vector3d& knot) const {
  return model_.approach.dot(model_.target - knot);
}

double KnotFixtures::lateralError(const Vector3d& knot) const {
  return (model_.target - knot).cross(model_.approach).norm();
}

Vector3d KnotFixtures::outward(int plane) const {
  const double angle = 2 * std::numbers::pi * plane / kPlanes;
  return std::cos(angle) * across_[0] + std::sin(angle) * across_[1];
}

TipPair KnotFixtures::constrain(const TipPair& tips, const Vector3d& knot, const TipPair& desired,
                                double seconds) {
  Constraints constraints;
  const Vector3d none = Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      const Vector3d direction = sign * Vector3d::Unit(axis);
      constraints.require(direction, none, -model_.speed * seconds);
      constraints.require(none, direction, -model_.speed * seconds);
    }
  }
  constraints.require(Vector3d::UnitZ(), none, model_.tissue - tips.left.z());
  constraints.require(none, Vector3d::UnitZ(), model_.tissue - tips.right.z());
  const Vector3d between = tips.left - tips.right;
  const Vector3d apart = between.normalized();
  constraints.require(apart, -apart, model_.separation - between.norm());

  // Use the cone where the knot will be, because it is narrower there.
  const double ahead = std::max(distanceToTarget(knot), 0.0);
  for (int plane = 0; plane < kPlanes; ++plane) {
    const Vector3d out = outward(plane);
    const double room = model_.radius + model_.slope * ahead - out.dot(knot - model_.target);
    constraints.requireOfMean(-out - model_.slope * model_.approach, -room);
  }
  const double nearest = std::min(ahead, (model_.slowing * ahead + kCreep) * seconds);
  constraints.requireOfMean(-model_.approach, -nearest);

  Program::Vector steps;
  steps << desired.left, desired.right;
  const Program::Solution solution =
      program_.solve(Program::Matrix::Identity(), -steps, constraints.rows, constraints.bounds);
  if (solution.status != SolveStatus::Optimal) return {none, none};
  return {solution.x.head<3>(), solution.x.tail<3>()};
}

}  // namespace robots
