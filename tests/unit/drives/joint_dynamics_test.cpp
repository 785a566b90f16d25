// Simulated joints keep their word: the declared lag, rates and limits are what the data show.

#include "drives/joint_dynamics.h"

#include <gtest/gtest.h>

#include <random>

namespace robots::test {
namespace {

using TwoJoints = Eigen::Vector2d;

JointDynamics<2> atRest(double timeConstant = 0.01, double rate = 1.0) {
  return {timeConstant, TwoJoints::Constant(rate), TwoJoints(-1, 0), TwoJoints(1, 0.2),
          TwoJoints::Zero()};
}

TEST(JointDynamics, ReachesOneTimeConstantsShare) {
  auto joints = atRest();
  joints.command(TwoJoints(0.005, 0));
  joints.advance(0.01);
  EXPECT_NEAR(joints.measured()[0], 0.005 * (1 - std::exp(-1)), 1e-15);
  EXPECT_EQ(joints.measured()[1], 0);
}

TEST(JointDynamics, NeverExceedsTheRateLimit) {
  auto joints = atRest();
  joints.command(TwoJoints(1, 0));
  joints.advance(0.1);
  EXPECT_DOUBLE_EQ(joints.measured()[0], 0.1);
  EXPECT_EQ(joints.velocity()[0], 1.0);
}

TEST(JointDynamics, CutsSetpointsToThePositionLimits) {
  auto joints = atRest();
  joints.command(TwoJoints(5, -5));
  EXPECT_EQ(joints.setpoint(), TwoJoints(1, 0));
  for (int i = 0; i < 2000; ++i) joints.advance(0.001);
  EXPECT_NEAR(joints.measured()[0], 1, 1e-12);
  EXPECT_EQ(joints.measured()[1], 0);
}

// The exact solution composes: the result depends on elapsed time, not on how it was sliced; also
// where the rate limit lets go in the middle of a step.
TEST(JointDynamics, TimeSlicesDoNotMatter) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(-1, 1), share(0, 1);
  for (int sample = 0; sample < 10'000; ++sample) {
    const LaggingJoint joint{0.001 + 0.05 * share(random), 0.1 + share(random)};
    const double start = value(random), setpoint = value(random), dt = share(random);
    const double first = dt * share(random);
    const double inTwo = joint.after(dt - first, joint.after(first, start, setpoint), setpoint);
    ASSERT_NEAR(joint.after(dt, start, setpoint), inTwo, 1e-12);
  }
}

TEST(JointDynamics, TrailsARampByTheTimeConstant) {
  const double timeConstant = 0.01, speed = 0.5, dt = 0.0001;
  auto joints = atRest(timeConstant);
  double setpoint = 0;
  while (setpoint < 0.5) {
    setpoint += speed * dt;
    joints.command(TwoJoints(setpoint, 0));
    joints.advance(dt);
  }
  EXPECT_NEAR(setpoint - joints.measured()[0], speed * timeConstant, speed * dt);
}

TEST(JointDynamics, RefusesAnImpossibleDeclaration) {
  EXPECT_THROW(atRest(0), std::invalid_argument);
  EXPECT_THROW(atRest(-1), std::invalid_argument);
  EXPECT_THROW(atRest(0.01, 0), std::invalid_argument);
}

}  // namespace
}  // namespace robots::test
