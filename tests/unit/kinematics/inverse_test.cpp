// Inverse kinematics undoes the forward one, stays within limits, and says when it cannot.

#include "kinematics/inverse.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/davinci.h"
#include "kinematics/pose_error.h"
#include "unit/kinematics/kdl_oracle.h"

namespace robots::kinematics::test {
namespace {

template <int N>
typename Chain<N>::Joints nearby(const Chain<N>& chain, const typename Chain<N>::Joints& q,
                                 double distance, std::mt19937& random) {
  std::uniform_real_distribution<double> offset(-distance, distance);
  typename Chain<N>::Joints start = q;
  for (int i = 0; i < N; ++i) start[i] += offset(random);
  return chain.clamp(start);
}

// A control loop starts each search from the last set-point, a few milliradians away.
template <int N>
void expectUndoesForward(const Chain<N>& chain) {
  std::mt19937 random(2);
  for (int sample = 0; sample < 10'000; ++sample) {
    const auto q = randomJoints(chain, random);
    const auto goal = chain.forward(q);
    const auto solution = inverse(chain, goal, nearby(chain, q, 0.01, random));
    ASSERT_TRUE(solution.found) << "q = " << q.transpose() << ", error " << solution.position_error
                                << " m, " << solution.orientation_error << " rad";
    ASSERT_TRUE(chain.within(solution.q));
    const auto error = poseError(chain.forward(solution.q), goal);
    ASSERT_LE(error.template head<3>().norm(), 1e-9);
    ASSERT_LE(error.template tail<3>().norm(), 1e-9);
  }
}

TEST(Inverse, UndoesForwardForThePsm) { expectUndoesForward(psm()); }
TEST(Inverse, UndoesForwardForTheLeftMtm) { expectUndoesForward(mtmLeft()); }
TEST(Inverse, UndoesForwardForTheRightMtm) { expectUndoesForward(mtmRight()); }

TEST(Inverse, NeedsNoIterationAtTheGoal) {
  const auto chain = psm();
  const Chain<6>::Joints q = Chain<6>::Joints::Constant(0.1);
  const auto solution = inverse(chain, chain.forward(q), q);
  EXPECT_TRUE(solution.found);
  EXPECT_EQ(solution.iterations, 0);
  EXPECT_EQ(solution.q, q);
}

TEST(Inverse, ReportsAPoseOutOfReach) {
  const auto chain = psm();
  const Chain<6>::Joints start = Chain<6>::Joints::Constant(0.1);
  Eigen::Isometry3d goal = chain.forward(start);
  goal.translation() += Eigen::Vector3d(0, 0, -1.0);
  const auto solution = inverse(chain, goal, start);
  EXPECT_FALSE(solution.found);
  EXPECT_TRUE(chain.within(solution.q));
  EXPECT_GT(solution.position_error, 0.5);
  EXPECT_EQ(solution.iterations, InverseOptions{}.max_iterations);
}

// Deeper than the insertion limit along the shaft, all other joints free: the only obstacle is the
// limit.
TEST(Inverse, ReportsAPoseBeyondALimit) {
  const auto chain = psm();
  Chain<6>::Joints beyond = Chain<6>::Joints::Zero();
  beyond[2] = chain.upper()[2] + 0.005;
  Chain<6>::Joints start = beyond;
  start[2] = chain.upper()[2] - 0.005;
  const auto solution = inverse(chain, chain.forward(beyond), start);
  EXPECT_FALSE(solution.found);
  EXPECT_TRUE(chain.within(solution.q));
  EXPECT_LT(solution.position_error, 0.006);
  EXPECT_TRUE(solution.limited);
}

// Returns what the search minimises: 0.1 m weigh as much as 1 rad.
double distance(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
  const auto error = poseError(from, to);
  return std::hypot(error.head<3>().norm() / 0.1, error.tail<3>().norm());
}

// One joint would have to leave its limits for these goals.
TEST(Inverse, LeavesThePsmNearestToItsGoal) {
  constexpr int N = 6;
  const auto chain = psm();
  std::mt19937 random(3);
  std::uniform_int_distribution<int> anyJoint(0, N - 1);
  for (int sample = 0; sample < 500; ++sample) {
    auto beyond = randomJoints(chain, random);
    const int joint = anyJoint(random);
    beyond[joint] = chain.upper()[joint] + 0.01;
    const auto goal = chain.forward(beyond);
    const auto start = nearby(chain, beyond, 0.01, random);
    const auto solution = inverse(chain, goal, start);
    if (solution.found) continue;  // another posture reaches it
    ASSERT_TRUE(solution.limited) << beyond.transpose();
    ASSERT_TRUE(chain.within(solution.q));
    const double reached = distance(chain.forward(solution.q), goal);
    ASSERT_LE(reached, distance(chain.forward(chain.clamp(beyond)), goal) + 1e-9);
    for (int i = 0; i < 50; ++i) {
      const auto beside = nearby(chain, solution.q, 0.001, random);
      ASSERT_LE(reached, distance(chain.forward(beside), goal) + 1e-6) << beyond.transpose();
    }
  }
}

TEST(Inverse, TellsUnreachableFromForbiddenGoals) {
  const auto chain = mtmLeft();
  const Chain<7>::Joints start = Chain<7>::Joints::Constant(0.1);
  Eigen::Isometry3d goal = chain.forward(start);
  goal.translation() += Eigen::Vector3d(0, 0, -3.0);  // the links are not that long
  const auto solution = inverse(chain, goal, start);
  EXPECT_FALSE(solution.found);
  EXPECT_FALSE(solution.limited);
  EXPECT_TRUE(chain.within(solution.q));
}

TEST(Inverse, StopsAfterTheIterationsItIsGiven) {
  const auto chain = mtmLeft();
  const Chain<7>::Joints start = Chain<7>::Joints::Constant(0.1);
  Eigen::Isometry3d goal = chain.forward(start);
  goal.translation().x() += 0.05;
  const auto solution = inverse(chain, goal, start, {.max_iterations = 1});
  EXPECT_FALSE(solution.found);
  EXPECT_EQ(solution.iterations, 1);
  EXPECT_LT(solution.position_error, 0.05);
}

TEST(Inverse, RefusesANonNumericGoal) {
  const auto chain = psm();
  Eigen::Isometry3d goal = Eigen::Isometry3d::Identity();
  goal.translation().x() = std::numeric_limits<double>::quiet_NaN();
  const Chain<6>::Joints start = Chain<6>::Joints::Constant(0.1);
  const auto solution = inverse(chain, goal, start);
  EXPECT_FALSE(solution.found);
  EXPECT_EQ(solution.q, start);
}

}  // namespace
}  // namespace robots::kinematics::test
