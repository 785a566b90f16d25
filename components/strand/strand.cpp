#include "strand/strand.h"

#include <algorithm>
#include <cmath>

namespace robots {
namespace {

// The links' directions change while they are drawn to their lengths, so they are computed anew
// this many times in a step.
constexpr int kRounds = 3;
// At least this much of the strand stays on each side, so that the knot does not run off.
constexpr double kShortestSide = 0.01;  // m
// The strand slips no faster than this, however hard it is pulled, because a step would overshoot
// otherwise.
constexpr double kFastestSlip = 0.1;  // m/s

}  // namespace

constexpr int Strand::nodeOf(Place place) {
  switch (place) {
    case Place::Left: return 0;
    case Place::Knot: return kKnot;
    case Place::Right: return kNodes - 1;
  }
  return 0;
}

Strand::Strand(const StrandModel& model, const Eigen::Vector3d& left, const Eigen::Vector3d& right)
    : model_(model),
      holdingRatio_(std::exp(model.friction * model.wrap)),
      leftLength_(model.length / 2) {
  for (int i = 0; i < kNodes; ++i) {
    nodes_.col(i) = left + (right - left) * i / (kNodes - 1);
  }
  mass_.setConstant(model.mass / kNodes);
  mass_[kKnot] += model.knot_mass;
  hold(Place::Left, left);
  hold(Place::Right, right);
}

void Strand::hold(Place place, const Eigen::Vector3d& point) {
  const int node = nodeOf(place);
  held_[static_cast<std::size_t>(node)] = true;
  nodes_.col(node) = point;
  velocities_.col(node).setZero();
}

void Strand::pull(Place place, const Eigen::Vector3d& force) {
  const int node = nodeOf(place);
  held_[static_cast<std::size_t>(node)] = false;
  forces_.col(node) = force;
}

void Strand::advance(double seconds) {
  const int steps = static_cast<int>(std::ceil(seconds / kStep - 1e-9));
  for (int i = 0; i < steps; ++i) step(seconds / steps);
}

double Strand::restLength(int link) const {
  return link < kKnot ? leftLength_ / kKnot : (model_.length - leftLength_) / (kLinks - kKnot);
}

void Strand::step(double h) {
  const Nodes before = nodes_;
  const double decay = std::exp(-model_.damping * h);
  for (int i = 0; i < kNodes; ++i) {
    if (held_[static_cast<std::size_t>(i)]) continue;
    velocities_.col(i) *= decay;
    velocities_.col(i) += h * (model_.gravity + forces_.col(i) / mass_[i]);
    nodes_.col(i) += h * velocities_.col(i);
  }
  projectConstraints(before, h);
  slip(h);
}

/// Draws the links to their lengths. A link's multiplier divided by the square of the step is its
/// tension.
void Strand::projectConstraints(const Nodes& before, double h) {
  const double compliance = 1 / (model_.stiffness * kLinks * h * h);
  std::array<double, kLinks> multiplier{};
  for (int round = 0; round < kRounds; ++round) {
    std::array<Eigen::Vector3d, kLinks> direction;
    std::array<double, kLinks> upper, change;  // the tridiagonal system, swept from the left
    const auto inverseMass = [&](int node) {
      return held_[static_cast<std::size_t>(node)] ? 0.0 : 1 / mass_[node];
    };
    double pivotBefore = 0;
    for (int i = 0; i < kLinks; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const Eigen::Vector3d span = nodes_.col(i + 1) - nodes_.col(i);
      const double length = span.norm();
      // A link without a length, whose two nodes lie in one place, pulls in no direction.
      direction[at] = length > 0 ? Eigen::Vector3d(span / length) : Eigen::Vector3d::Zero();
      double pivot = inverseMass(i) + inverseMass(i + 1) + compliance;
      double right = length - restLength(i) - compliance * multiplier[at];
      if (i > 0) {
        const double coupling = -inverseMass(i) * direction[at].dot(direction[at - 1]);
        upper[at - 1] = coupling / pivotBefore;
        pivot -= coupling * upper[at - 1];
        right -= coupling * change[at - 1];
      }
      change[at] = right / pivot;
      pivotBefore = pivot;
    }
    for (int i = kLinks - 2; i >= 0; --i) {
      const auto at = static_cast<std::size_t>(i);
      change[at] -= upper[at] * change[at + 1];
    }
    for (int i = 0; i < kLinks; ++i) {
      const auto at = static_cast<std::size_t>(i);
      multiplier[at] += change[at];
      nodes_.col(i) += inverseMass(i) * change[at] * direction[at];
      nodes_.col(i + 1) -= inverseMass(i + 1) * change[at] * direction[at];
    }
  }
  for (int i = 0; i < kNodes; ++i) {
    if (held_[static_cast<std::size_t>(i)]) continue;
    nodes_(2, i) = std::max(nodes_(2, i), model_.tissue);
    velocities_.col(i) = (nodes_.col(i) - before.col(i)) / h;
  }
  std::transform(multiplier.begin(), multiplier.end(), tension_.begin(),
                 [&](double one) { return one / (h * h); });
}

/// Lets the strand run through the knot, towards the side that pulls harder.
void Strand::slip(double h) {
  const double left = std::max(leftTension(), 0.0), right = std::max(rightTension(), 0.0);
  const double beyond =
      std::max(left - holdingRatio_ * right, 0.0) - std::max(right - holdingRatio_ * left, 0.0);
  const double speed = std::clamp(model_.slip * beyond, -kFastestSlip, kFastestSlip);
  leftLength_ = std::clamp(leftLength_ + h * speed, kShortestSide, model_.length - kShortestSide);
}

}  // namespace robots
