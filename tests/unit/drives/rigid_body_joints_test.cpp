// These test motors, controllers and brakes around joints that have mass.

#include "drives/rigid_body_joints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "unit/drives/davinci_models.h"

namespace robots::test {
namespace {

constexpr int kYaw = 0, kInsertion = 2;

template <int N>
void cycle(RigidBodyJoints<N>& joints, const typename RigidBodyModel<N>::Joints& goal) {
  joints.advance(kDriveCycle);
  joints.command(goal);
}

template <int N>
double tipMoved(const kinematics::Chain<N>& chain, RigidBodyJoints<N>& joints, double seconds) {
  const Eigen::Vector3d before = chain.forward(joints.position()).translation();
  for (double t = 0; t < seconds; t += kDriveCycle) cycle<N>(joints, joints.measured());
  return (chain.forward(joints.position()).translation() - before).norm();
}

TEST(ReleasedMtm, StaysWhereItIsWithGravityCompensation) {
  RigidBodyJoints<7> joints(released(heavyMtm()));
  EXPECT_LT(tipMoved(kinematics::mtmLeft(), joints, 2), 0.001);
}

// Friction alone does not hold it: without any it stays nearly as well.
TEST(ReleasedMtm, ItsMotorsHoldItWithoutFriction) {
  auto model = released(heavyMtm());
  model.mechanics.coulomb *= 0.05;
  RigidBodyJoints<7> joints(model);
  EXPECT_LT(tipMoved(kinematics::mtmLeft(), joints, 2), 0.001);
}

TEST(ReleasedMtm, FallsToItsStopsWithoutCompensation) {
  RigidBodyJoints<7> joints(released(heavyMtm({.gravity_compensation = false})));
  const auto chain = kinematics::mtmLeft();
  double moved = 0;
  for (int i = 0; i < 20; ++i) {
    moved += tipMoved(chain, joints, 0.1);
    ASSERT_TRUE(chain.within(joints.position())) << joints.position().transpose();
  }
  EXPECT_GT(moved, 0.1);
}

// Moves all joints smoothly at once, 0.2 rad far (20 mm of the insertion), there and back in 2 s.
template <int N>
typename RigidBodyModel<N>::Joints worstOfAMotion(const RigidBodyModel<N>& model,
                                                  const typename RigidBodyModel<N>::Joints& far) {
  using Joints = typename RigidBodyModel<N>::Joints;
  RigidBodyJoints<N> joints(model);
  const Joints start = joints.position();
  Joints worst = Joints::Zero(), goal = start;
  for (double t = 0; t < 2.5; t += kDriveCycle) {
    const double swing = std::sin(std::numbers::pi / 2 * std::min(t, 2.0));
    cycle<N>(joints, goal);
    worst = worst.cwiseMax((joints.position() - goal).cwiseAbs());
    goal = start + swing * swing * far;
  }
  return worst;
}

TEST(Following, ThePsmKeepsToItsStatedError) {
  RigidBodyModel<6>::Joints far = RigidBodyModel<6>::Joints::Constant(0.2);
  far[kInsertion] = 0.02;
  auto worst = worstOfAMotion<6>(heavyPsm(), far);
  EXPECT_LT(worst[kInsertion], 0.00015);
  worst[kInsertion] = 0;
  EXPECT_LT(worst.maxCoeff(), 0.0025) << worst.transpose();
}

TEST(Following, TheMtmKeepsToItsStatedError) {
  const auto worst = worstOfAMotion<7>(heavyMtm(), RigidBodyModel<7>::Joints::Constant(0.2));
  EXPECT_LT(worst.head<3>().maxCoeff(), 0.008) << worst.transpose();
  EXPECT_LT(worst.maxCoeff(), 0.012) << worst.transpose();
}

TEST(Effort, IsNoMoreThanTheMotorGives) {
  auto model = heavyPsm({.gravity_compensation = false});
  model.rate_limit.setConstant(1000);
  const double limit = model.mechanics.effort_limit[kYaw];
  RigidBodyJoints<6> joints(model);
  const RigidBodyModel<6>::Joints goal = model.parked + 1.5 * RigidBodyModel<6>::Joints::Unit(kYaw);
  cycle<6>(joints, goal);
  EXPECT_EQ(joints.effort()[kYaw], limit);
  const dynamics::ArmDynamics<6> arm(model.chain, model.mechanics.links);
  const double inertia = arm.inertia(arm.at(model.parked))(kYaw, kYaw);
  constexpr double kTime = 30 * kDriveCycle;
  for (int i = 0; i < 30; ++i) cycle<6>(joints, goal);
  EXPECT_GT(joints.position()[kYaw], 0.4 * limit / inertia * kTime * kTime);
  EXPECT_LT(joints.position()[kYaw], 0.5 * limit / inertia * kTime * kTime);
}

// Two motors of an MTM act on its shoulder, so that it may get more than either gives.
TEST(Effort, IsWithinWhatEachMotorGives) {
  auto model = heavyMtm();
  model.rate_limit.setConstant(1000);
  RigidBodyJoints<7> joints(model);
  const RigidBodyModel<7>::Joints goal = model.parked + RigidBodyModel<7>::Joints::Constant(0.2);
  cycle<7>(joints, goal);
  const auto& limit = model.mechanics.motor_limit;
  const RigidBodyModel<7>::Joints motors = model.coupling.actuatorEfforts(joints.effort());
  for (int i = 0; i < 7; ++i) EXPECT_LE(std::abs(motors[i]), limit[i] * (1 + 1e-12)) << i;
  EXPECT_NEAR(motors[2], limit[2], 1e-12);
  EXPECT_GT(std::abs(joints.effort()[1] - motors[1]), 1) << "that of the elbow acts there too";
}

// A client that pushes all the time would speed it up until it hits its stop.
TEST(Effort, KeepsAReleasedJointsRateLimit) {
  auto model = heavyMtm();
  model.rate_limit.setConstant(1);
  RigidBodyJoints<7> joints(model);
  MotorOrder<7> order;
  order.effort[kYaw] = model.mechanics.effort_limit[kYaw];
  order.released.setConstant(true);
  double fastest = 0;
  for (int i = 0; i < 400; ++i) {
    joints.order(order);
    cycle<7>(joints, joints.measured());
    fastest = std::max(fastest, joints.velocity()[kYaw]);
  }
  EXPECT_GT(fastest, 1);
  EXPECT_LT(fastest, 1.2);
}

TEST(Encoders, CountWhatTheirMotorsTurn) {
  const auto model = heavyMtm();
  RigidBodyJoints<7> joints(model);
  for (int i = 0; i < 300; ++i) cycle<7>(joints, kinematics::mtmHome() * (1 + 0.001 * i));
  const RigidBodyModel<7>::Joints counts =
      model.coupling.actuators(joints.measured()).cwiseQuotient(model.mechanics.encoder_step);
  EXPECT_LT((counts.array() - counts.array().round()).abs().maxCoeff(), 1e-6);
  EXPECT_GT(counts.cwiseAbs().maxCoeff(), 1);
}

// The joint itself may be faster for a moment, when it was slower before. Without a limit it would
// reach 1 m/s.
TEST(SetPoint, GoesNoFasterThanTheRateLimit) {
  const auto model = heavyPsm();
  RigidBodyJoints<6> joints(model);
  double fastest = 0;
  for (int i = 0; i < 1500; ++i) {
    const double before = joints.position()[kInsertion];
    cycle<6>(joints, model.parked + 0.1 * RigidBodyModel<6>::Joints::Unit(kInsertion));
    fastest = std::max(fastest, (joints.position()[kInsertion] - before) / kDriveCycle);
  }
  EXPECT_NEAR(joints.position()[kInsertion], 0.2, 1e-4);
  EXPECT_LT(fastest, 1.6 * model.rate_limit[kInsertion]);
}

TEST(Brakes, HoldWhatWouldFall) {
  RigidBodyJoints<7> joints(released(heavyMtm({.gravity_compensation = false})));
  const auto parked = joints.position();
  for (int i = 0; i < 150; ++i) joints.advance(kDriveCycle);
  EXPECT_EQ(joints.position(), parked) << "without power from the start";
  tipMoved(kinematics::mtmLeft(), joints, 0.2);
  joints.brake();
  const auto held = joints.position();
  EXPECT_NE(held, parked);
  for (int i = 0; i < 150; ++i) joints.advance(kDriveCycle);
  EXPECT_EQ(joints.position(), held);
  EXPECT_LT(joints.velocity().cwiseAbs().maxCoeff(), 1e-6);
}

TEST(Brakes, KeepAnUnpoweredArmFromSinking) {
  RigidBodyJoints<7> joints(heavyMtm({.brakes = false}));
  const auto chain = kinematics::mtmLeft();
  EXPECT_LT(tipMoved(chain, joints, 0.2), 0.001) << "with power it stays";
  const auto height = [&] { return chain.forward(joints.position()).translation().z(); };
  const double before = height();
  joints.brake();
  for (int i = 0; i < 750; ++i) joints.advance(kDriveCycle);
  EXPECT_LT(height(), before - 0.02);
  EXPECT_TRUE(chain.within(joints.position()));
  EXPECT_EQ(joints.effort(), RigidBodyModel<7>::Joints::Zero());
  const auto caught = joints.measured();
  for (int i = 0; i < 1500; ++i) cycle<7>(joints, caught);
  EXPECT_LT((joints.position() - caught).cwiseAbs().maxCoeff(), 0.01) << "power catches it";
}

TEST(Brakes, LetGoWithoutAJerk) {
  RigidBodyJoints<7> joints(heavyMtm());
  const auto chain = kinematics::mtmLeft();
  EXPECT_LT(tipMoved(chain, joints, 0.5), 0.001);
  for (int i = 0; i < 300; ++i) cycle<7>(joints, kinematics::mtmHome() * 0.8);
  EXPECT_NE(joints.effort(), RigidBodyModel<7>::Joints::Zero());
  joints.brake();  // in the middle of a motion
  EXPECT_EQ(joints.effort(), RigidBodyModel<7>::Joints::Zero());
  EXPECT_LT(tipMoved(chain, joints, 0.5), 0.001);
}

std::vector<double> trace(std::uint32_t seed) {
  RigidBodyJoints<7> joints(heavyMtm({.noise = 1, .seed = seed}));
  std::vector<double> trace;
  for (int i = 0; i < 300; ++i) {
    joints.advance(i % 3 == 0 ? 2 * kDriveCycle : kDriveCycle);
    joints.command(kinematics::mtmHome() * (1 + 0.001 * i));
    for (int joint = 0; joint < 7; ++joint) trace.push_back(joints.measured()[joint]);
    trace.push_back(joints.position()[kYaw]);
  }
  return trace;
}

TEST(Traces, AreEqualWhereSeedsAre) {
  EXPECT_EQ(trace(1), trace(1));
  EXPECT_NE(trace(1), trace(2));
}

TEST(RigidBodyModel, IsRefusedWhenImpossible) {
  auto still = heavyPsm();
  still.rate_limit[kYaw] = 0;
  EXPECT_THROW(RigidBodyJoints<6>{still}, std::invalid_argument);
  auto unstable = heavyPsm();
  unstable.damping[kYaw] = -1;
  EXPECT_THROW(RigidBodyJoints<6>{unstable}, std::invalid_argument);
}

}  // namespace
}  // namespace robots::test
