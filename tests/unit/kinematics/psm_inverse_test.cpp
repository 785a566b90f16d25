// The closed form of the PSM is exact everywhere, near its start, and calm where the arm is
// singular.

#include "kinematics/psm_inverse.h"

#include "kinematics/davinci.h"
#include "unit/kinematics/closed_form.h"

namespace robots::kinematics::test {
namespace {

using Psm = Chain<6>::Joints;

// This is the insertion at which the wrist stands in the remote centre (m).
constexpr double kInCentre = kPsmCarriage - kPsmShaft;

TEST(PsmInverse, ReachesAllThatTheLimitsAdmit) {
  expectReachesAll<6>(psm(), kdlPsm(), psmInverse, 100'000);
}
TEST(PsmInverse, StaysNearItsStart) { expectStaysNear<6>(psm(), psmInverse); }
TEST(PsmInverse, ReachesTheLimits) { expectReachesAllCorners<6>(psm(), psmInverse); }
TEST(PsmInverse, IsNearestToAForbiddenGoal) { expectNearestWithinLimits<6>(psm(), psmInverse); }
TEST(PsmInverse, RefusesWhatIsNotFinite) { expectRefusesWhatIsNotFinite<6>(psm(), psmInverse); }
TEST(PsmInverse, ReachesARoundedRotation) { expectReachesARoundedRotation<6>(psm(), psmInverse); }

TEST(PsmInverse, IsContinuousAlongAPath) {
  Psm centre, amplitude;
  centre << 0, 0, 0.13, 0, 0, 0;
  amplitude << 1.2, 0.8, 0.08, 4.3, 1.2, 1.2;
  EXPECT_LT(largestStep<6>(psm(), psmInverse, centre, amplitude), 0.05);
}

TEST(PsmInverse, FindsItsOwnJointsAgain) {
  const auto chain = psm();
  std::mt19937 random(21);
  for (int sample = 0; sample < 10'000; ++sample) {
    Psm q = randomJoints(chain, random);
    q[2] = 0.05 + 0.75 * q[2];
    const auto solution = psmInverse(chain, chain.forward(q), q);
    ASSERT_LT((solution.q - q).cwiseAbs().maxCoeff(), 1e-9) << q.transpose();
  }
}

// The goal is beyond the limit of the roll, and the other turn would reach it.
TEST(PsmInverse, SlidesWhereAnotherTurnReaches) {
  const auto chain = psm();
  Psm q = Psm::Constant(0.1);
  q[3] = chain.upper()[3] + 0.01;
  const Psm start = chain.clamp(q);
  const auto far = psmInverse(chain, chain.forward(q), start);
  EXPECT_TRUE(far.found);
  EXPECT_LT(far.q[3], 0);
  const auto nearest = psmInverse(chain, chain.forward(q), start, Postures::Near);
  EXPECT_FALSE(nearest.found);
  EXPECT_TRUE(nearest.limited);
  EXPECT_LT((nearest.q - start).cwiseAbs().maxCoeff(), 0.02);
}

TEST(PsmInverse, TakesTheNearestTurnOfTheRoll) {
  const auto chain = psm();
  Psm q = Psm::Constant(0.1);
  for (const double roll : {-4.4, -2.0, 2.0, 4.4}) {
    q[3] = roll;
    Psm start = q;
    start[3] = roll + (roll > 0 ? -0.3 : 0.3);
    const auto solution = psmInverse(chain, chain.forward(q), start);
    EXPECT_NEAR(solution.q[3], roll, 1e-9);
  }
}

// There yaw, pitch, roll and wrist pitch have a motion that leaves the tool where it is.
TEST(PsmInverse, KeepsTheShaftAtTheRemoteCentre) {
  const auto chain = psm();
  std::mt19937 random(22);
  for (int sample = 0; sample < 10'000; ++sample) {
    Psm q = 0.9 * randomJoints(chain, random);
    q[2] = kInCentre;
    Psm start = near(chain, q, 0.01, random);
    start[2] = kInCentre;
    const auto goal = chain.forward(q);
    const auto solution = psmInverse(chain, goal, start);
    ASSERT_NO_FATAL_FAILURE(expectFound(chain, solution, goal)) << q.transpose();
    // Yaw and roll turn more for the same way of the shaft where that is tilted.
    ASSERT_LT((solution.q - start).cwiseAbs().maxCoeff(), 0.08) << q.transpose();
  }
}

// Returns the insertion, above the remote centre, at which the wrist's yaw axis leads through that.
double insertionWithYawAxisThroughCentre(double wristPitch) {
  return kInCentre - kPsmWrist / std::cos(wristPitch);
}

TEST(PsmInverse, KeepsTheWristAtTheRemoteCentre) {
  const auto chain = psm();
  std::mt19937 random(23);
  for (int sample = 0; sample < 10'000; ++sample) {
    Psm q = 0.9 * randomJoints(chain, random);
    q[4] *= 0.6;
    q[2] = insertionWithYawAxisThroughCentre(q[4]);
    const auto goal = chain.forward(q);
    const auto solution = psmInverse(chain, goal, q);
    ASSERT_NO_FATAL_FAILURE(expectFound(chain, solution, goal)) << q.transpose();
    ASSERT_LT((solution.q - q).cwiseAbs().maxCoeff(), 1e-4) << q.transpose();
    const Psm start = near(chain, q, 0.01, random);
    ASSERT_NO_FATAL_FAILURE(expectFound(chain, psmInverse(chain, goal, start), goal))
        << q.transpose();
  }
}

TEST(PsmInverse, IsExactBesideItsSingularPoses) {
  const auto chain = psm();
  std::mt19937 random(24);
  for (const double beside : {1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-6, 1e-4}) {
    for (int sample = 0; sample < 2000; ++sample) {
      Psm q = 0.9 * randomJoints(chain, random);
      q[4] *= 0.6;
      q[2] = sample % 2 == 0 ? kInCentre : insertionWithYawAxisThroughCentre(q[4]);
      q[2] += sample % 4 < 2 ? beside : -beside;
      const auto goal = chain.forward(q);
      ASSERT_NO_FATAL_FAILURE(expectFound(chain, psmInverse(chain, goal, q), goal))
          << beside << " m beside, q = " << q.transpose();
    }
  }
}

TEST(PsmInverse, SaysThatLimitsForbidTheFarAway) {
  const auto chain = psm();
  const Psm start = Psm::Constant(0.1);
  for (const Eigen::Vector3d& way : {Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(0, 1, 1)}) {
    Eigen::Isometry3d goal = chain.forward(start);
    goal.translation() += way;
    const auto solution = psmInverse(chain, goal, start);
    EXPECT_FALSE(solution.found);
    EXPECT_TRUE(solution.limited);
    EXPECT_TRUE(chain.within(solution.q));
    EXPECT_LT(solution.position_error, way.norm());
  }
}

}  // namespace
}  // namespace robots::kinematics::test
