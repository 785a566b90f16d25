// The closed form of the MTMs is exact everywhere, near its start, with the platform as its
// parameter.

#include "kinematics/mtm_inverse.h"

#include "kinematics/davinci.h"
#include "unit/kinematics/closed_form.h"

namespace robots::kinematics::test {
namespace {

using Mtm = Chain<7>::Joints;

constexpr int kPlatform = 3, kWristPitch = 4, kWristYaw = 5, kMtmRoll = 6;

TEST(MtmInverse, ReachesAllOfTheLeftMaster) {
  expectReachesAll<7>(mtmLeft(), kdlMtm(), mtmInverse, 100'000);
}
TEST(MtmInverse, ReachesAllOfTheRightMaster) {
  expectReachesAll<7>(mtmRight(), kdlMtm(), mtmInverse, 20'000);
}
TEST(MtmInverse, StaysNearItsStart) {
  expectStaysNear<7>(mtmLeft(), mtmInverse);
  expectStaysNear<7>(mtmRight(), mtmInverse);
}
TEST(MtmInverse, ReachesTheLimits) { expectReachesAllCorners<7>(mtmLeft(), mtmInverse); }
TEST(MtmInverse, IsNearestToAForbiddenGoal) { expectNearestWithinLimits<7>(mtmLeft(), mtmInverse); }
TEST(MtmInverse, RefusesWhatIsNotFinite) { expectRefusesWhatIsNotFinite<7>(mtmLeft(), mtmInverse); }
TEST(MtmInverse, ReachesARoundedRotation) {
  expectReachesARoundedRotation<7>(mtmLeft(), mtmInverse);
}

TEST(MtmInverse, IsContinuousAlongAPath) {
  const Mtm centre = mtmHome();
  Mtm amplitude;
  amplitude << 0.5, 0.5, 0.5, 0.6, 0.6, 0.3, 3;
  EXPECT_LT(largestStep<7>(mtmLeft(), mtmInverse, centre, amplitude), 0.1);
}

// The axes of platform and roll are in line, so that one of the two could turn for the other.
TEST(MtmInverse, KeepsPlatformAndRollWhenInLine) {
  const auto chain = mtmLeft();
  std::mt19937 random(31);
  for (int sample = 0; sample < 10'000; ++sample) {
    Mtm q = 0.9 * randomJoints(chain, random);
    q[kWristPitch] = sample % 2 == 0 ? kHalfPi : -kHalfPi;
    q[kWristYaw] = 0;
    const auto goal = chain.forward(q);
    const auto solution = mtmInverse(chain, goal, near(chain, q, 0.01, random));
    ASSERT_NO_FATAL_FAILURE(expectFound(chain, solution, goal)) << q.transpose();
    ASSERT_LT((solution.q - q).cwiseAbs().maxCoeff(), 0.05) << q.transpose();
  }
}

TEST(MtmInverse, KeepsTheYawAtItsSingularity) {
  const auto chain = mtmLeft();
  Mtm start = mtmHome();
  start[0] = 0.3;
  Eigen::Isometry3d goal = chain.forward(start);
  goal.translation() = Eigen::Vector3d(0, 0, -0.4);
  const auto solution = mtmInverse(chain, goal, start);
  EXPECT_FALSE(solution.found);
  EXPECT_TRUE(solution.limited);
  EXPECT_NEAR(solution.q[0], start[0], 0.1);
  const auto joints = mtmAtPlatform(chain, goal, 0, start);
  ASSERT_TRUE(joints);
  EXPECT_EQ((*joints)[0], start[0]);
  EXPECT_LT(missedBy(chain.forward(*joints), goal), 1e-9);
}

TEST(MtmInverse, LeavesThePlatformWhereItsLimitIs) {
  const auto chain = mtmLeft();
  std::mt19937 random(32);
  for (int sample = 0; sample < 5'000; ++sample) {
    Mtm q = randomJoints(chain, random);
    q[kPlatform] = (sample % 2 == 0 ? chain.lower() : chain.upper())[kPlatform];
    const auto goal = chain.forward(q);
    const auto solution = mtmInverse(chain, goal, q);
    ASSERT_NO_FATAL_FAILURE(expectFound(chain, solution, goal)) << q.transpose();
    ASSERT_LT((solution.q - q).cwiseAbs().maxCoeff(), 1e-6) << q.transpose();
  }
}

TEST(MtmInverse, TakesTheNearestTurnOfTheRoll) {
  const auto chain = mtmLeft();
  Mtm q = mtmHome();
  for (const double roll : {-8.3, -5.0, 0.0, 3.5, 7.8}) {
    q[kMtmRoll] = roll;
    const auto solution = mtmInverse(chain, chain.forward(q), q);
    EXPECT_NEAR(solution.q[kMtmRoll], roll, 1e-9);
  }
}

TEST(MtmInverse, ReachesWithAnyPlatformAngle) {
  const auto chain = mtmLeft();
  std::mt19937 random(33);
  const double lower = chain.lower()[kPlatform], upper = chain.upper()[kPlatform];
  std::uniform_real_distribution<double> between(lower, upper);
  for (int sample = 0; sample < 10'000; ++sample) {
    const Mtm q = randomJoints(chain, random);
    const auto goal = chain.forward(q);
    for (const double platform : {lower, between(random), upper}) {
      const auto joints = mtmAtPlatform(chain, goal, platform, q);
      ASSERT_TRUE(joints);
      ASSERT_EQ((*joints)[kPlatform], platform);
      ASSERT_LT(missedBy(chain.forward(*joints), goal), 1e-9) << q.transpose();
    }
    const auto same = mtmAtPlatform(chain, goal, q[kPlatform], q);
    ASSERT_LT((*same - q).cwiseAbs().maxCoeff(), 1e-8) << q.transpose();
  }
}

TEST(MtmInverse, TellsOutOfReachFromLimits) {
  const auto chain = mtmLeft();
  const Mtm start = mtmHome();
  Eigen::Isometry3d goal = chain.forward(start);
  goal.translation() = Eigen::Vector3d(0, -0.8, 0);  // the links are not that long
  auto solution = mtmInverse(chain, goal, start);
  EXPECT_FALSE(solution.found);
  EXPECT_FALSE(solution.limited);
  EXPECT_TRUE(chain.within(solution.q));
  EXPECT_FALSE(mtmAtPlatform(chain, goal, 0, start));
  goal.translation() = Eigen::Vector3d(0, 0.5, 0);  // behind the yaw
  solution = mtmInverse(chain, goal, start);
  EXPECT_FALSE(solution.found);
  EXPECT_TRUE(solution.limited);
  EXPECT_TRUE(chain.within(solution.q));
  goal.translation().x() = std::nan("");
  EXPECT_FALSE(mtmAtPlatform(chain, goal, 0, start));
}

}  // namespace
}  // namespace robots::kinematics::test
