#include "guidance/fixtures.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace robots {
namespace {

using Eigen::Vector3d;

// The last tenths of a millimetre need a minimum speed, or the knot would never arrive.
constexpr double kCreep = 0.0005;  // m/s
// A strand this near to the line of approach, in m, has no direction away from it.
constexpr double kStraight = 1e-6;

/// Says how far one side of the strand, `strand` from the knot to a tip, leans from the line of
/// approach.
struct Steepness {
  Steepness(const Vector3d& strand, const Vector3d& approach) {
    const Vector3d aside = strand - strand.dot(approach) * approach;
    const double distance = std::max(aside.norm(), kStraight);
    const double length = std::max(strand.norm(), kStraight);
    logarithm = std::log(distance / length);
    gradient = aside / (distance * distance) - strand / (length * length);
  }

  double logarithm;   // that of the angle's sine
  Vector3d gradient;  // 1/m: how the logarithm grows
};

}  // namespace

/// Holds the rows as they are added, always in the same order, because the solver begins with those
/// that were active in the last step. Each says that its product with the steps is at least its
/// bound. No bound is above zero, so that standing still is permitted, whatever has happened.
struct KnotFixtures::Constraints {
  Program::Rows rows = Program::Rows::Zero();
  Program::Bounds bounds = Program::Bounds::Zero();
  int count = 0;

  /// The row gets the length one, which the solver needs. A row without a length or a bound forbids
  /// nothing.
  void require(const Vector3d& left, const Vector3d& right, double atLeast) {
    const int row = count++;
    const double length = std::sqrt(left.squaredNorm() + right.squaredNorm());
    if (length < kLeastLength || atLeast == -std::numeric_limits<double>::infinity()) return;
    rows.row(row) << left.transpose() / length, right.transpose() / length;
    bounds[row] = std::min(atLeast / length, 0.0);
  }
  /// Does the same for the mean of both steps.
  void requireOfMean(const Vector3d& direction, double atLeast) {
    require(direction / 2, direction / 2, atLeast);
  }

  static constexpr double kLeastLength = 1e-9;
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

// Without these bounds the solver would make good with one tip, whose operator may rest, what a
// fixture takes from the other.
void KnotFixtures::forbidHaste(const TipPair& desired, double seconds,
                               Constraints& constraints) const {
  const Vector3d none = Vector3d::Zero();
  const double left = std::min(model_.speed * seconds, desired.left.norm());
  const double right = std::min(model_.speed * seconds, desired.right.norm());
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      const Vector3d direction = sign * Vector3d::Unit(axis);
      constraints.require(direction, none, -left);
      constraints.require(none, direction, -right);
    }
  }
  constraints.require(desired.left, none, 0);
  constraints.require(none, desired.right, 0);
}

void KnotFixtures::forbidContact(const TipPair& tips, Constraints& constraints) const {
  const Vector3d none = Vector3d::Zero();
  constraints.require(Vector3d::UnitZ(), none, model_.tissue - tips.left.z());
  constraints.require(none, Vector3d::UnitZ(), model_.tissue - tips.right.z());
  const Vector3d between = tips.left - tips.right;
  const Vector3d apart = between.normalized();
  constraints.require(apart, -apart, model_.separation - between.norm());
}

// The cone is used where the knot will be, because it is narrower there.
void KnotFixtures::forbidLeavingCorridor(const Vector3d& knot, double seconds,
                                         Constraints& constraints) const {
  const double ahead = std::max(distanceToTarget(knot), 0.0);
  for (int plane = 0; plane < kPlanes; ++plane) {
    const Vector3d out = outward(plane);
    const double room = model_.radius + model_.slope * ahead - out.dot(knot - model_.target);
    constraints.requireOfMean(-out - model_.slope * model_.approach, -room);
  }
  const double nearest = std::min(ahead, (model_.slowing * ahead + kCreep) * seconds);
  constraints.requireOfMean(-model_.approach, -nearest);
}

// The logarithm of the tensions' ratio changes with the tips' steps by its gradient. The knot goes
// with their mean, so each tip goes from it by half of the difference.
void KnotFixtures::forbidSliding(const TipPair& tips, const Vector3d& knot,
                                 Constraints& constraints) const {
  const Steepness left(tips.left - knot, model_.approach);
  const Steepness right(tips.right - knot, model_.approach);
  const double ratio = right.logarithm - left.logarithm, most = std::log(model_.holding);
  const Vector3d change = (left.gradient + right.gradient) / 2;
  constraints.require(-change, change, -most - ratio);
  constraints.require(change, -change, ratio - most);
}

TipPair KnotFixtures::constrain(const TipPair& tips, const Vector3d& knot, const TipPair& desired,
                                double seconds, const RoomPair& rooms) {
  Constraints constraints;
  forbidHaste(desired, seconds, constraints);
  forbidContact(tips, constraints);
  forbidLeavingCorridor(knot, seconds, constraints);
  forbidSliding(tips, knot, constraints);
  const Vector3d none = Vector3d::Zero();
  for (int joint = 0; joint < kTipJoints; ++joint) {
    const Vector3d left = rooms.left.motion.row(joint), right = rooms.right.motion.row(joint);
    constraints.require(left, none, rooms.left.least[joint]);
    constraints.require(-left, none, -rooms.left.most[joint]);
    constraints.require(none, right, rooms.right.least[joint]);
    constraints.require(none, -right, -rooms.right.most[joint]);
  }

  Program::Vector steps;
  steps << desired.left, desired.right;
  const Program::Solution solution =
      program_.solve(Program::Matrix::Identity(), -steps, constraints.rows, constraints.bounds);
  if (solution.status != SolveStatus::Optimal) return {none, none};
  return {solution.x.head<3>(), solution.x.tail<3>()};
}

}  // namespace robots
