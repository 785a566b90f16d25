// These compare forward kinematics and Jacobian of the da Vinci arms with KDL.

#include "kinematics/davinci.h"

#include <gtest/gtest.h>

#include "kinematics/pose_error.h"
#include "unit/kinematics/kdl_davinci.h"

namespace robots::kinematics::test {
namespace {

constexpr int kSamples = 10'000;

template <int N>
void expectSameAsKdl(const Chain<N>& chain, const KDL::Chain& oracle) {
  std::mt19937 random(1);
  for (int sample = 0; sample < kSamples; ++sample) {
    const auto q = randomJoints(chain, random);
    const auto error = poseError(forward(oracle, q), chain.forward(q));
    ASSERT_LT(error.template head<3>().norm(), 1e-9) << "q = " << q.transpose();
    ASSERT_LT(error.template tail<3>().norm(), 1e-9) << "q = " << q.transpose();
    ASSERT_LT((jacobian(oracle, q) - chain.jacobian(q)).cwiseAbs().maxCoeff(), 1e-9)
        << "q = " << q.transpose();
  }
}

TEST(DaVinci, PsmAgreesWithKdl) { expectSameAsKdl(psm(), kdlPsm()); }
TEST(DaVinci, LeftMtmAgreesWithKdl) { expectSameAsKdl(mtmLeft(), kdlMtm()); }
TEST(DaVinci, RightMtmAgreesWithKdl) { expectSameAsKdl(mtmRight(), kdlMtm()); }

// The roll frame is 0.4162 m beyond a carriage that starts 0.4318 m behind, so the wrist reaches
// the remote centre when the insertion makes up the difference.
TEST(DaVinci, PsmWristMeetsTheRemoteCentre) {
  const double wristAtCentre = 0.4318 - 0.4162;
  Chain<6>::Joints q = Chain<6>::Joints::Zero();
  q[2] = wristAtCentre;
  EXPECT_NEAR(psm().forward(q).translation().norm(), 0.0091, 1e-12);
}

TEST(DaVinci, MastersDifferOnlyInMirroredLimits) {
  const auto left = mtmLeft();
  const auto right = mtmRight();
  for (const int mirrored : {0, 3}) {
    EXPECT_EQ(left.lower()[mirrored], -right.upper()[mirrored]);
    EXPECT_EQ(left.upper()[mirrored], -right.lower()[mirrored]);
  }
  EXPECT_EQ(left.lower()[1], -0.262);
  EXPECT_EQ(right.lower()[1], -0.314);
}

TEST(DaVinci, LimitsAreInclusiveAndClampIsInside) {
  const auto chain = psm();
  EXPECT_TRUE(chain.within(chain.lower()));
  EXPECT_TRUE(chain.within(chain.upper()));
  const Chain<6>::Joints outside = 2 * chain.upper();
  EXPECT_FALSE(chain.within(outside));
  EXPECT_EQ(chain.clamp(outside), chain.upper());
}

}  // namespace
}  // namespace robots::kinematics::test
