// Friction and stops act on the joints as they should.

#include "dynamics/joint_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/davinci_inertia.h"
#include "kinematics/davinci.h"

namespace robots::dynamics::test {
namespace {

using Joints = JointMotion<6>::Joints;

constexpr double kCycle = 1.0 / 1500;
constexpr int kYaw = 0, kInsertion = 2, kRoll = 3;

// There is no gravity here, so that nothing moves a joint but what a test does.
class JointMotionTest : public ::testing::Test {
 protected:
  void cycles(int count) {
    for (int i = 0; i < count; ++i) motion_.advance(kCycle, effort_);
  }

  const kinematics::Chain<6> chain_ = kinematics::psm();
  const ArmMechanics<6> arm_ = psmMechanics();
  JointMotion<6> motion_{ArmDynamics<6>(chain_, arm_.links, Eigen::Vector3d::Zero()),
                         {.viscous = arm_.viscous,
                          .coulomb = arm_.coulomb,
                          .lower = chain_.lower(),
                          .upper = chain_.upper()},
                         Joints::Unit(kInsertion) * 0.1};
  Joints effort_ = Joints::Zero();
};

TEST_F(JointMotionTest, FrictionHoldsAJoint) {
  const Joints start = motion_.position();
  effort_ = 0.99 * arm_.coulomb;
  cycles(1500);
  EXPECT_LT((motion_.position() - start).cwiseAbs().maxCoeff(), 1e-12);
  effort_[kRoll] = 1.5 * arm_.coulomb[kRoll];
  cycles(1500);
  EXPECT_GT(motion_.position()[kRoll], 0.1);
}

TEST_F(JointMotionTest, FrictionStopsASlowJoint) {
  effort_[kYaw] = 0.5;
  cycles(150);
  EXPECT_GT(motion_.velocity()[kYaw], 0.05);
  effort_[kYaw] = 0;
  cycles(1500);
  EXPECT_LT(std::abs(motion_.velocity()[kYaw]), 1e-12);
  const double stopped = motion_.position()[kYaw];
  EXPECT_LT(stopped, chain_.upper()[kYaw]) << "it was a stop";
  cycles(1500);
  EXPECT_NEAR(motion_.position()[kYaw], stopped, 1e-12);
}

// A constant force ends in a constant speed: (effort - coulomb) / viscous.
TEST_F(JointMotionTest, FrictionBoundsAForcesSpeed) {
  effort_[kRoll] = arm_.coulomb[kRoll] + 0.5 * arm_.viscous[kRoll];
  cycles(600);
  EXPECT_NEAR(motion_.velocity()[kRoll], 0.5, 1e-6);
}

TEST_F(JointMotionTest, StrongFrictionPreventsMotion) {
  JointMotion<6> tough(ArmDynamics<6>(chain_, arm_.links, Eigen::Vector3d::Zero()),
                       {.viscous = 1000 * arm_.viscous,
                        .coulomb = Joints::Zero(),
                        .lower = chain_.lower(),
                        .upper = chain_.upper()},
                       motion_.position());
  for (int i = 0; i < 300; ++i) tough.advance(kCycle, Joints::Unit(kRoll));
  EXPECT_NEAR(tough.velocity()[kRoll], 1 / (1000 * arm_.viscous[kRoll]), 1e-6);
}

// They are met again and again, as each meeting falls elsewhere in a step.
TEST_F(JointMotionTest, NoStopIsPassed) {
  for (int i = 0; i < 9000; ++i) {
    const double sign = i / 900 % 2 == 0 ? 1 : -1;
    effort_[kInsertion] = sign * arm_.effort_limit[kInsertion];
    effort_[kYaw] = -sign * arm_.effort_limit[kYaw];
    cycles(1);
    ASSERT_TRUE(chain_.within(motion_.position())) << motion_.position().transpose();
  }
}

TEST_F(JointMotionTest, NoStopThrowsBack) {
  effort_[kInsertion] = arm_.effort_limit[kInsertion];
  effort_[kYaw] = -arm_.effort_limit[kYaw];
  cycles(3000);
  EXPECT_EQ(motion_.position()[kInsertion], chain_.upper()[kInsertion]);
  EXPECT_EQ(motion_.position()[kYaw], chain_.lower()[kYaw]);
  EXPECT_NEAR(motion_.velocity()[kInsertion], 0, 1e-12);
  effort_ = -effort_;
  cycles(300);
  EXPECT_LT(motion_.position()[kInsertion], chain_.upper()[kInsertion]);
  EXPECT_GT(motion_.position()[kYaw], chain_.lower()[kYaw]);
}

TEST_F(JointMotionTest, BrakesCatchIt) {
  effort_[kYaw] = 1;
  cycles(300);
  ASSERT_GT(motion_.velocity()[kYaw], 0.1);
  motion_.halt();
  EXPECT_EQ(motion_.velocity(), Joints::Zero());
}

// A call after a second moves the joints by no more than its steps.
TEST_F(JointMotionTest, ALateCallDoesNotLast) {
  effort_[kRoll] = arm_.coulomb[kRoll] + arm_.viscous[kRoll];
  cycles(600);
  const double before = motion_.position()[kRoll], speed = motion_.velocity()[kRoll];
  motion_.advance(1.0, effort_);
  const double most = JointMotion<6>::kStep * JointMotion<6>::kMostSteps;
  EXPECT_NEAR(motion_.position()[kRoll] - before, speed * most, 1e-6);
}

TEST_F(JointMotionTest, TimeThatDoesNotPassChangesNothing) {
  effort_[kYaw] = 1;
  cycles(10);
  const Joints position = motion_.position(), velocity = motion_.velocity();
  motion_.advance(0, effort_);
  EXPECT_EQ(motion_.position(), position);
  EXPECT_EQ(motion_.velocity(), velocity);
}

}  // namespace
}  // namespace robots::dynamics::test
