#include "arm/kinematics/inverse.h"

#include <Eigen/Cholesky>

#include "arm/kinematics/pose_error.h"

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

// The damped step; joints at a limit that the gradient pushes outward take no part.
template <int N>
typename Chain<N>::Joints dampedStep(const Chain<N>& chain, const typename Chain<N>::Joints& q,
                                     const Vector6& error) {
  const Vector6 weight = weights();
  const typename Chain<N>::Jacobian jacobian = chain.jacobian(q);
  typename Chain<N>::Joints gradient = jacobian.transpose() * weight.cwiseProduct(error);
  Eigen::Matrix<double, N, N> normal = jacobian.transpose() * weight.asDiagonal() * jacobian;
  normal.diagonal().array() += 0.5 * error.dot(weight.cwiseProduct(error)) + kMinimumDamping;
  for (int i = 0; i < N; ++i) {
    const bool pushedOut = (q[i] >= chain.upper()[i] && gradient[i] > 0) ||
                           (q[i] <= chain.lower()[i] && gradient[i] < 0);
    if (!pushedOut) continue;
    normal.row(i).setZero();
    normal.col(i).setZero();
    normal(i, i) = 1;
    gradient[i] = 0;
  }
  return normal.llt().solve(gradient);
}

}  // namespace

template <int N>
InverseSolution<N> inverse(const Chain<N>& chain, const Eigen::Isometry3d& goal,
                           const typename Chain<N>::Joints& start, const InverseOptions& options) {
  InverseSolution<N> solution;
  solution.q = chain.clamp(start);
  for (;; ++solution.iterations) {
    const Vector6 error = poseError(chain.forward(solution.q), goal);
    solution.position_error = error.template head<3>().norm();
    solution.orientation_error = error.template tail<3>().norm();
    solution.found = solution.position_error <= options.position_tolerance &&
                     solution.orientation_error <= options.orientation_tolerance;
    const bool spent = solution.iterations >= options.max_iterations || !error.allFinite();
    if (solution.found || spent) return solution;
    solution.q = chain.clamp(solution.q + dampedStep(chain, solution.q, error));
  }
}

template InverseSolution<6> inverse(const Chain<6>&, const Eigen::Isometry3d&,
                                    const Chain<6>::Joints&, const InverseOptions&);
template InverseSolution<7> inverse(const Chain<7>&, const Eigen::Isometry3d&,
                                    const Chain<7>::Joints&, const InverseOptions&);

}  // namespace robots::kinematics
