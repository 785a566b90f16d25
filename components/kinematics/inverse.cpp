#include "kinematics/inverse.h"

#include <Eigen/Cholesky>

#include "kinematics/pose_error.h"
#include "kinematics/spatial_vector.h"
#include "kinematics/step_within_limits.h"

namespace robots::kinematics {
namespace {

// A step this small (rad or m) leads nowhere: the search stands at the nearest point that the
// limits admit.
constexpr double kStandstill = 1e-12;

enum class Limits { Heeded, Ignored };

template <int N>
typename Chain<N>::Joints dampedStep(const Chain<N>& chain, const typename Chain<N>::Joints& q,
                                     const SpatialVector& error, Limits limits) {
  const SpatialVector weight = poseWeights();
  const typename Chain<N>::Jacobian jacobian = chain.jacobian(q);
  const typename Chain<N>::Joints descent = jacobian.transpose() * weight.cwiseProduct(error);
  Eigen::Matrix<double, N, N> normal = jacobian.transpose() * weight.asDiagonal() * jacobian;
  normal.diagonal().array() += 0.5 * error.dot(weight.cwiseProduct(error)) + kMinimumDamping;
  if (limits == Limits::Ignored) return normal.llt().solve(descent);
  return stepWithinLimits(chain, q, normal, descent).value_or(Chain<N>::Joints::Zero());
}

template <int N>
InverseSolution<N> search(const Chain<N>& chain, const Eigen::Isometry3d& goal,
                          const typename Chain<N>::Joints& start, const InverseOptions& options,
                          Limits limits) {
  InverseSolution<N> solution;
  solution.q = start;
  for (;; ++solution.iterations) {
    const SpatialVector error = poseError(chain.forward(solution.q), goal);
    solution.position_error = error.template head<3>().norm();
    solution.orientation_error = error.template tail<3>().norm();
    solution.found = solution.position_error <= options.position_tolerance &&
                     solution.orientation_error <= options.orientation_tolerance;
    const bool spent = solution.iterations >= options.max_iterations || !error.allFinite();
    if (solution.found || spent) return solution;
    const typename Chain<N>::Joints before = solution.q;
    solution.q += dampedStep(chain, before, error, limits);
    if (limits == Limits::Heeded) solution.q = chain.clamp(solution.q);
    if ((solution.q - before).cwiseAbs().maxCoeff() <= kStandstill) return solution;
  }
}

// Returns true if a joint is at its limit.
template <int N>
bool isAtLimit(const Chain<N>& chain, const typename Chain<N>::Joints& q) {
  return (q.array() <= chain.lower().array()).any() || (q.array() >= chain.upper().array()).any();
}

}  // namespace

template <int N>
InverseSolution<N> inverse(const Chain<N>& chain, const Eigen::Isometry3d& goal,
                           const typename Chain<N>::Joints& start, const InverseOptions& options) {
  InverseSolution<N> solution = search(chain, goal, chain.clamp(start), options, Limits::Heeded);
  solution.limited = !solution.found && isAtLimit(chain, solution.q) &&
                     search(chain, goal, solution.q, options, Limits::Ignored).found;
  return solution;
}

template InverseSolution<6> inverse(const Chain<6>&, const Eigen::Isometry3d&,
                                    const Chain<6>::Joints&, const InverseOptions&);
template InverseSolution<7> inverse(const Chain<7>&, const Eigen::Isometry3d&,
                                    const Chain<7>::Joints&, const InverseOptions&);

}  // namespace robots::kinematics
