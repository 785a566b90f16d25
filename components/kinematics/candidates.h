#pragma once
// This is what the closed forms share: they choose among postures, and check the one that they
// choose.

#include <limits>
#include <optional>

#include "kinematics/nearest.h"
#include "kinematics/pose_error.h"
#include "kinematics/turns.h"

namespace robots::kinematics {

/// Returns how far each joint moves, in rad; 0.1 m count as 1 rad.
template <int N>
typename Chain<N>::Joints jointDistances(const Chain<N>& chain,
                                         const typename Chain<N>::Joints& from,
                                         const typename Chain<N>::Joints& to) {
  typename Chain<N>::Joints difference = to - from;
  for (int i = 0; i < N; ++i) {
    if (chain.kind(i) == JointKind::Prismatic) difference[i] /= kLengthScale;
  }
  return difference;
}

template <int N>
double squaredDistance(const Chain<N>& chain, const typename Chain<N>::Joints& from,
                       const typename Chain<N>::Joints& to) {
  return jointDistances(chain, from, to).squaredNorm();
}

/// Collects the postures that lead to one goal as if there were no limits. Chain and start are kept
/// by reference. Never allocates.
template <int N>
class Candidates {
 public:
  using Joints = typename Chain<N>::Joints;

  Candidates(const Chain<N>& chain, const Joints& start, Postures postures)
      : chain_(chain), start_(start), postures_(postures) {}

  /// Adds a posture, unless it is not finite.
  void add(const Joints& q) {
    if (!q.allFinite()) return;
    offered_ = true;
    if (postures_ == Postures::Near && !isNear(q)) return;
    const Joints cut = chain_.clamp(q);
    const bool isWithin = (q - cut).cwiseAbs().maxCoeff() <= kLimitSlack;
    (isWithin ? within_ : beyond_).take(squaredDistance(chain_, start_, q), cut);
  }

  /// Returns the posture within the limits that is nearest to the start. If there is none, returns
  /// the nearest point within the limits, searched from the start or from the nearest of the other
  /// postures cut to the limits, whichever comes closer to the goal. `reachable` says that the
  /// candidates reach the goal but for the limits. A goal that only a posture far away reaches is
  /// limited if the search comes to its end, to a limit, or to 1 cm and 0.1 rad beside the goal;
  /// otherwise it is out of reach from here.
  InverseSolution<N> choose(const Eigen::Isometry3d& goal, bool reachable) const {
    InverseSolution<N> solution = nearestWithinLimits(chain_, goal, beginning(goal));
    const bool byLimits = postures_ == Postures::All || beyond_.q || hasArrived(solution);
    solution.limited = !solution.found && reachable && offered_ && byLimits;
    return solution;
  }

 private:
  struct Nearest {
    std::optional<Joints> q;
    double distance = std::numeric_limits<double>::infinity();

    void take(double offered, const Joints& joints) {
      if (!(offered < distance)) return;
      q = joints;
      distance = offered;
    }
  };

  bool hasArrived(const InverseSolution<N>& solution) const {
    constexpr double kClose = 0.01, kCloseAngle = 0.1;  // m, rad
    return solution.iterations < kMostNearestSteps || isAtLimit(solution.q) ||
           (solution.position_error < kClose && solution.orientation_error < kCloseAngle);
  }
  bool isAtLimit(const Joints& q) const {
    return ((q - chain_.lower()).array() <= kLimitSlack).any() ||
           ((chain_.upper() - q).array() <= kLimitSlack).any();
  }
  bool isNear(const Joints& q) const {
    return jointDistances(chain_, start_, q).cwiseAbs().maxCoeff() <= 1;
  }
  Joints beginning(const Eigen::Isometry3d& goal) const {
    if (within_.q) return *within_.q;
    Joints begin = chain_.clamp(start_);
    if (beyond_.q && missedBy(goal, *beyond_.q) < missedBy(goal, begin)) begin = *beyond_.q;
    return begin;
  }
  double missedBy(const Eigen::Isometry3d& goal, const Joints& q) const {
    const auto error = poseError(chain_.forward(q), goal);
    return error.dot(poseWeights().cwiseProduct(error));
  }

  const Chain<N>& chain_;
  const Joints& start_;
  Postures postures_;
  bool offered_ = false;
  Nearest within_, beyond_;
};

}  // namespace robots::kinematics
