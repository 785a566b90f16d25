#pragma once
// This is one step of a search that respects joint limits.

#include <Eigen/Cholesky>
#include <optional>

#include "kinematics/chain.h"

namespace robots::kinematics {

/// Keeps the curvature definite along the self-motion of a redundant arm, and in a singular posture
/// when the error is already tiny.
constexpr double kMinimumDamping = 1e-9;

/// Returns true if the joint is at a limit, and `direction` leads it outward.
template <int N>
bool leadsOut(const Chain<N>& chain, const typename Chain<N>::Joints& q,
              const typename Chain<N>::Joints& direction, int i) {
  return (q[i] >= chain.upper()[i] && direction[i] > 0) ||
         (q[i] <= chain.lower()[i] && direction[i] < 0);
}

/// Solves `curvature` * step = `descent`, where joints at a limit that the descent or the step
/// would push outward take no part. Returns nothing unless the curvature is positive definite. It
/// factors at most N + 1 times, and never allocates.
template <int N>
std::optional<typename Chain<N>::Joints> stepWithinLimits(const Chain<N>& chain,
                                                          const typename Chain<N>::Joints& q,
                                                          Eigen::Matrix<double, N, N> curvature,
                                                          typename Chain<N>::Joints descent) {
  typename Chain<N>::Joints step = descent;
  // Each iteration but the last holds at least one joint more.
  for (bool solved = false;; solved = true) {
    bool holdsMore = false;
    for (int i = 0; i < N; ++i) {
      if (!leadsOut(chain, q, step, i)) continue;
      curvature.row(i).setZero();
      curvature.col(i).setZero();
      curvature(i, i) = 1;
      descent[i] = 0;
      holdsMore = true;
    }
    if (solved && !holdsMore) return step;
    const Eigen::LLT<Eigen::Matrix<double, N, N>> factors(curvature);
    if (factors.info() != Eigen::Success) return std::nullopt;
    step = factors.solve(descent);
  }
}

}  // namespace robots::kinematics
