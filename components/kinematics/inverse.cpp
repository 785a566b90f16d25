#include "kinematics/inverse.h"

#include <Eigen/Cholesky>

#include "kinematics/pose_error.h"

namespace robots::kinematics {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

// One radian of orientation error weighs as much as this many metres of position error.
constexpr double kLengthScale = 0.1;
// Keeps the normal matrix definite for a redundant or singular chain when the error is already
// tiny.
constexpr double kMinimumDamping = 1e-9;

Vector6 weights() {
  Vector6 weights;
  weights << Eigen::Vector3d::Constant(1 / (kLengthScale * kLengthScale)), Eigen::Vector3d::Ones();
  return weights;
}

// So small a step (rad or m) leads nowhere: the search stands at the nearest that the limits leave.
constexpr double kStandstill = 1e-12;

enum class Limits { Heeded, Ignored };

// The joint is at a limit, and `direction` leads it outward.
template <int N>
bool leadsOut(const Chain<N>& chain, const typename Chain<N>::Joints& q,
              const typename Chain<N>::Joints& direction, int i) {
  return (q[i] >= chain.upper()[i] && direction[i] > 0) ||
         (q[i] <= chain.lower()[i] && direction[i] < 0);
}

// The damped step; joints at a limit that the gradient or the step would push outward take no part.
template <int N>
typename Chain<N>::Joints dampedStep(const Chain<N>& chain, const typename Chain<N>::Joints& q,
                                     const Vector6& error, Limits limits) {
  const Vector6 weight = weights();
  const typename Chain<N>::Jacobian jacobian = chain.jacobian(q);
  typename Chain<N>::Joints gradient = jacobian.transpose() * weight.cwiseProduct(error);
  Eigen::Matrix<double, N, N> normal = jacobian.transpose() * weight.asDiagonal() * jacobian;
  normal.diagonal().array() += 0.5 * error.dot(weight.cwiseProduct(error)) + kMinimumDamping;
  typename Chain<N>::Joints direction = gradient;
  // Each turn but the last holds at least one joint more.
  for (bool solved = false;; solved = true) {
    bool holdsMore = false;
    for (int i = 0; i < N && limits == Limits::Heeded; ++i) {
      if (!leadsOut(chain, q, direction, i)) continue;
      normal.row(i).setZero();
      normal.col(i).setZero();
      normal(i, i) = 1;
      gradient[i] = 0;
      holdsMore = true;
    }
    if (solved && !holdsMore) return direction;
    direction = normal.llt().solve(gradient);
  }
}

template <int N>
InverseSolution<N> search(const Chain<N>& chain, const Eigen::Isometry3d& goal,
                          const typename Chain<N>::Joints& start, const InverseOptions& options,
                          Limits limits) {
  InverseSolution<N> solution;
  solution.q = start;
  for (;; ++solution.iterations) {
    const Vector6 error = poseError(chain.forward(solution.q), goal);
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

// A joint rests against its limit.
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
