#pragma once
// Every closed form must keep these rules, whichever arm it belongs to.

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/candidates.h"
#include "kinematics/inverse.h"
#include "unit/kinematics/kdl_davinci.h"

namespace robots::kinematics::test {

template <int N>
typename Chain<N>::Joints near(const Chain<N>& chain, const typename Chain<N>::Joints& q,
                               double distance, std::mt19937& random) {
  std::uniform_real_distribution<double> offset(-distance, distance);
  typename Chain<N>::Joints start = q;
  for (int i = 0; i < N; ++i) start[i] += offset(random);
  return chain.clamp(start);
}

/// Returns the error with the weights of the answers.
inline double missedBy(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
  const auto error = poseError(from, to);
  return std::sqrt(error.dot(poseWeights().cwiseProduct(error)));
}

template <int N>
void expectFound(const Chain<N>& chain, const InverseSolution<N>& solution,
                 const Eigen::Isometry3d& goal) {
  ASSERT_TRUE(solution.found) << solution.position_error << " m, " << solution.orientation_error;
  ASSERT_FALSE(solution.limited);
  ASSERT_TRUE(chain.within(solution.q)) << solution.q.transpose();
  const auto error = poseError(chain.forward(solution.q), goal);
  ASSERT_LE(error.template head<3>().norm(), 1e-9) << solution.q.transpose();
  ASSERT_LE(error.template tail<3>().norm(), 1e-9) << solution.q.transpose();
}

/// Expects an answer from anywhere to anywhere, which KDL confirms.
template <int N>
void expectReachesAll(const Chain<N>& chain, const KDL::Chain& oracle, InverseFunction<N> solve,
                      int samples) {
  std::mt19937 random(11);
  for (int sample = 0; sample < samples; ++sample) {
    const auto q = randomJoints(chain, random);
    const auto goal = forward(oracle, q);
    const auto solution = solve(chain, goal, randomJoints(chain, random), Postures::All);
    ASSERT_NO_FATAL_FAILURE(expectFound(chain, solution, goal)) << "q = " << q.transpose();
    ASSERT_EQ(solution.iterations, 0) << "the closed form alone, q = " << q.transpose();
    ASSERT_LT(missedBy(forward(oracle, solution.q), goal), 1e-9) << "q = " << q.transpose();
  }
}

/// Joints near the start reach the goal, so that no others farther away may be the answer.
template <int N>
void expectStaysNear(const Chain<N>& chain, InverseFunction<N> solve) {
  std::mt19937 random(12);
  for (int sample = 0; sample < 20'000; ++sample) {
    const auto q = randomJoints(chain, random);
    const auto start = near(chain, q, 0.02, random);
    for (const Postures postures : {Postures::All, Postures::Near}) {
      const auto solution = solve(chain, chain.forward(q), start, postures);
      ASSERT_TRUE(solution.found) << q.transpose();
      ASSERT_LE(squaredDistance(chain, start, solution.q),
                squaredDistance(chain, start, q) * 1.001 + 1e-9)
          << "q = " << q.transpose() << "\nsolution = " << solution.q.transpose();
    }
  }
}

/// Expects an answer with every joint at one of its limits.
template <int N>
void expectReachesAllCorners(const Chain<N>& chain, InverseFunction<N> solve) {
  std::mt19937 random(13);
  for (int corner = 0; corner < (1 << N); ++corner) {
    typename Chain<N>::Joints q;
    for (int i = 0; i < N; ++i) q[i] = corner & (1 << i) ? chain.upper()[i] : chain.lower()[i];
    const auto goal = chain.forward(q);
    ASSERT_NO_FATAL_FAILURE(expectFound(chain, solve(chain, goal, q, Postures::All), goal))
        << q.transpose();
    const auto start = near(chain, q, 0.02, random);
    ASSERT_NO_FATAL_FAILURE(expectFound(chain, solve(chain, goal, start, Postures::All), goal))
        << q.transpose();
  }
}

/// Follows a path whose joints keep to the limits: the answers move as slowly as those do. Returns
/// the largest step of a joint, with 0.1 m as one radian; those of the path are below 0.01.
template <int N>
double largestStep(const Chain<N>& chain, InverseFunction<N> solve,
                   const typename Chain<N>::Joints& centre,
                   const typename Chain<N>::Joints& amplitude) {
  double largest = 0;
  auto last = centre;
  for (int step = 1; step <= 20'000; ++step) {
    auto q = centre;
    for (int i = 0; i < N; ++i) q[i] += amplitude[i] * std::sin(1e-3 * (5 + i) * step);
    const auto solution = solve(chain, chain.forward(q), last, Postures::Near);
    EXPECT_TRUE(solution.found) << q.transpose();
    largest = std::max(largest, std::sqrt(squaredDistance(chain, last, solution.q)));
    last = solution.q;
  }
  return largest;
}

/// Goals that one joint would have to leave its limits for: the answer is the nearest point. Its
/// bounded search may stop before that, but seldom, and never far from what the general one finds.
template <int N>
void expectNearestWithinLimits(const Chain<N>& chain, InverseFunction<N> solve) {
  std::mt19937 random(14);
  std::uniform_int_distribution<int> anyJoint(0, N - 1);
  int limited = 0, nearest = 0;
  for (int sample = 0; sample < 1000; ++sample) {
    auto beyond = randomJoints(chain, random);
    const int joint = anyJoint(random);
    beyond[joint] = chain.upper()[joint] + 0.01;
    const auto goal = chain.forward(beyond);
    const auto start = near(chain, beyond, 0.01, random);
    const auto solution = solve(chain, goal, start, Postures::Near);
    const auto searched = inverse(chain, goal, start);
    ASSERT_TRUE(chain.within(solution.q));
    ASSERT_TRUE(solution.found || !searched.found) << beyond.transpose();
    if (solution.found) continue;  // another posture reaches it
    ++limited;
    ASSERT_TRUE(solution.limited) << beyond.transpose();
    const double missed = missedBy(chain.forward(solution.q), goal);
    const double missedBySearch = missedBy(chain.forward(searched.q), goal);
    ASSERT_LE(missed, missedBySearch + 1e-3) << beyond.transpose();
    double missedBeside = missedBySearch;
    for (int i = 0; i < 20; ++i) {
      const auto beside = near(chain, solution.q, 0.001, random);
      missedBeside = std::min(missedBeside, missedBy(chain.forward(beside), goal));
    }
    nearest += missed <= missedBeside + 1e-6;
  }
  ASSERT_GT(limited, 300);
  ASSERT_GE(nearest, limited * 99 / 100);
}

/// Wherever a number is not finite.
template <int N>
void expectRefusesWhatIsNotFinite(const Chain<N>& chain, InverseFunction<N> solve) {
  const auto start = chain.clamp(Chain<N>::Joints::Constant(0.1));
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        Eigen::Isometry3d goal = chain.forward(start);
        goal.matrix()(row, column) = bad;
        const auto solution = solve(chain, goal, start, Postures::Near);
        EXPECT_FALSE(solution.found);
        EXPECT_FALSE(solution.limited);
        EXPECT_EQ(solution.q, start);
      }
    }
  }
}

/// Rotations from elsewhere are not orthonormal to the last digit.
template <int N>
void expectReachesARoundedRotation(const Chain<N>& chain, InverseFunction<N> solve) {
  std::mt19937 random(15);
  for (int sample = 0; sample < 1000; ++sample) {
    const auto q = randomJoints(chain, random);
    Eigen::Isometry3d goal = chain.forward(q);
    goal.linear() += 1e-7 * Eigen::Matrix3d::Random();
    const auto solution = solve(chain, goal, near(chain, q, 0.01, random), Postures::All);
    ASSERT_TRUE(solution.found || solution.orientation_error < 1e-6) << q.transpose();
    ASSERT_LT(solution.position_error, 1e-6) << q.transpose();
    ASSERT_LE(solution.iterations, 4) << q.transpose();
  }
}

}  // namespace robots::kinematics::test
