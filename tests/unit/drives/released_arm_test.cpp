// These arms have motors that clients push with, and that carry the arm's weight if they are to.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "arm_control/mtm.h"
#include "arm_control/psm.h"
#include "drives/mtm_drives.h"
#include "drives/psm_drives.h"
#include "dynamics/davinci_inertia.h"
#include "kinematics/davinci.h"
#include "support/pass.h"
#include "unit/drives/davinci_models.h"
#include "unit/drives/robot_in_process.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using suture::pass;
using Joints7 = RigidBodyModel<7>::Joints;

constexpr std::size_t kYaw = 0, kShoulder = 1;

/// A ReleasedArm is an enabled master, which is held at first.
class ReleasedArm : public testing::Test {
 protected:
  JointEffortGoal effort(std::size_t joint, double value) const {
    JointEffortGoal goal;
    goal.effort.assign(7, 0.0);
    goal.effort[joint] = value;
    return goal;
  }
  void push(suture::Duration duration, const JointEffortGoal& goal) {
    robot_.stream(duration, [&] { return robot_.panel.arm.servo_jf(goal); });
  }
  void release(suture::Duration duration) { push(duration, effort(kYaw, 0)); }
  void compensate(bool use) { EXPECT_TRUE(robot_.panel.arm.use_gravity_compensation(use)); }
  Joints7 joints() const { return Joints7::Map(mtm_.motion().measured_js().position.data()); }
  Joints7 efforts() const { return Joints7::Map(mtm_.motion().measured_js().effort.data()); }
  Eigen::Vector3d tip() const { return mtm_.motion().measured_cp().pose.translation(); }
  Joints7 weight() const {
    const dynamics::ArmDynamics<7> arm(kinematics::mtmLeft(), mechanics_.links);
    return arm.gravity(arm.at(joints()));
  }
  void expectState(ArmState state, const char* activity) const {
    EXPECT_EQ(mtm_.operating_state().state, state);
    EXPECT_EQ(mtm_.operating_state().sub_state, activity);
  }
  /// Lets time pass, and returns how far a joint moved in a millisecond at most.
  double quickest(suture::Duration duration) const {
    double most = 0;
    for (suture::Duration t{0}; t < duration; t += 1ms) {
      const Joints7 before = joints();
      pass(1ms);
      most = std::max(most, (joints() - before).cwiseAbs().maxCoeff());
    }
    return most;
  }

  const dynamics::ArmMechanics<7> mechanics_ = dynamics::mtmMechanics();
  Mtm mtm_{MtmParameters{}};
  MtmDrives drives_{
      {.permit = {}, .dynamics = DriveDynamics::RigidBody, .rigid_body = {.quantisation = false}}};
  Robot<Mtm, MtmDrives> robot_{mtm_, drives_};
};

TEST_F(ReleasedArm, ItsMotorsKeepItWithinAMillimetre) {
  const Eigen::Vector3d before = tip();
  release(5s);
  expectState(ArmState::Enabled, "servo_jf");
  EXPECT_LT((tip() - before).norm(), 0.001);
  EXPECT_LT((efforts() - weight()).cwiseAbs().maxCoeff(), 1e-3) << "they do nothing else";
}

TEST_F(ReleasedArm, FallsIfTheyDoNot) {
  compensate(false);
  const Eigen::Vector3d before = tip();
  release(2s);
  expectState(ArmState::Enabled, "servo_jf");
  EXPECT_GT((tip() - before).norm(), 0.05);
  EXPECT_EQ(efforts(), Joints7::Zero());
}

TEST_F(ReleasedArm, IsReleasedByFreeWithoutAStream) {
  const Eigen::Vector3d before = tip();
  EXPECT_TRUE(robot_.panel.arm.free());
  pass(3s);
  expectState(ArmState::Enabled, "free");
  EXPECT_LT((tip() - before).norm(), 0.001);
  compensate(false);
  pass(2s);
  EXPECT_GT((tip() - before).norm(), 0.05);
  EXPECT_EQ(efforts(), Joints7::Zero());
}

TEST_F(ReleasedArm, IsCaughtWhereItIs) {
  compensate(false);
  release(300ms);
  compensate(true);
  const Joints7 falling = joints();
  EXPECT_TRUE(robot_.panel.arm.hold());
  pass(1s);
  EXPECT_LT((joints() - falling).cwiseAbs().maxCoeff(), 0.15);
  const Joints7 held = joints();
  pass(1s);
  EXPECT_LT((joints() - held).cwiseAbs().maxCoeff(), 1e-3);
}

// A controller without an integral part is off by as much as its stiffness leaves of a load.
TEST_F(ReleasedArm, SinksByWeightOverStiffness) {
  const Joints7 stiffness = heavyMtm().stiffness;
  const Joints7 before = joints(), load = weight();
  compensate(false);
  EXPECT_LT(quickest(1s), 1e-3) << "it does not jump";
  const Joints7 sunk = (joints() - before).cwiseAbs();
  for (int i = 0; i < 7; ++i) {
    EXPECT_LE(sunk[i], (std::abs(load[i]) + 2 * mechanics_.coulomb[i]) / stiffness[i]) << i;
  }
  EXPECT_GT(sunk[kShoulder],
            (std::abs(load[kShoulder]) - mechanics_.coulomb[kShoulder]) / stiffness[kShoulder] / 2);
  compensate(true);
  EXPECT_LT(quickest(1s), 1e-3);
  for (int i = 0; i < 7; ++i) {
    EXPECT_LE(std::abs(joints()[i] - before[i]), 2 * mechanics_.coulomb[i] / stiffness[i]) << i;
  }
  expectState(ArmState::Enabled, "holding");
}

TEST_F(ReleasedArm, GivesTheEffortThatAClientStreams) {
  const Joints7 before = joints();
  push(300ms, effort(kYaw, 0.5));
  EXPECT_NEAR(efforts()[kYaw], 0.5 + weight()[kYaw], 1e-3);
  EXPECT_NEAR(efforts()[kShoulder], weight()[kShoulder], 0.01);
  EXPECT_GT(joints()[kYaw] - before[kYaw], 0.02);
}

TEST_F(ReleasedArm, GivesNoMoreThanJointsTake) {
  push(200ms, effort(kYaw, -100));
  expectState(ArmState::Enabled, "servo_jf");
  EXPECT_LE(std::abs(efforts()[kYaw]), mechanics_.effort_limit[kYaw] * (1 + 1e-9));
  EXPECT_LT(mtm_.motion().measured_js().velocity[kYaw], -0.5);
}

TEST_F(ReleasedArm, HoldsTheJointsOutsideOfTheMask) {
  JointEffortGoal goal = effort(kYaw, 0.5);
  goal.effort[kShoulder] = 0.5;
  goal.mask.assign(7, true);
  goal.mask[kYaw] = false;
  const Joints7 before = joints();
  push(300ms, goal);
  EXPECT_NEAR(joints()[kYaw], before[kYaw], 0.005);
  EXPECT_GT(std::abs(joints()[kShoulder] - before[kShoulder]), 0.02);
}

TEST_F(ReleasedArm, IsHeldWhenTheStreamFallsSilent) {
  push(200ms, effort(kYaw, 0.5));
  pass(150ms);
  expectState(ArmState::Enabled, "holding");
  pass(500ms);
  const Joints7 held = joints();
  pass(1s);
  EXPECT_LT((joints() - held).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_LT(std::abs(efforts()[kYaw] - weight()[kYaw]), 0.3) << "the client's effort is gone";
  EXPECT_EQ(drives_.feedback().power, DrivePower::On);
}

TEST_F(ReleasedArm, IsNotReleasedWhileDisabled) {
  push(200ms, effort(kYaw, 0.5));
  EXPECT_TRUE(robot_.panel.arm.pause());
  pass(300ms);
  const Joints7 paused = joints();
  push(1s, effort(kYaw, 1));
  expectState(ArmState::Paused, "paused");
  EXPECT_LT((joints() - paused).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_TRUE(robot_.panel.arm.disable());
  push(300ms, effort(kYaw, 1));
  expectState(ArmState::Disabled, "");
  EXPECT_EQ(efforts(), Joints7::Zero());
}

TEST_F(ReleasedArm, PressesWithTheStreamedWrench) {
  EXPECT_TRUE(robot_.panel.arm.home());
  pass(3s);
  ASSERT_TRUE(mtm_.operating_state().is_homed);
  WrenchGoal goal;
  goal.force = {0.5, -1, 1.5};
  robot_.stream(50ms, [&] { return robot_.panel.arm.spatial_servo_cf(goal); });
  const Wrench spatial = robot_.ask(robot_.panel.arm.spatial_measured_cf);
  ASSERT_TRUE(spatial.valid);
  EXPECT_LT((spatial.force - goal.force).norm(), 0.02) << spatial.force.transpose();
  expectState(ArmState::Enabled, "servo_cf");
  robot_.stream(50ms, [&] { return robot_.panel.arm.body_servo_cf(goal); });
  const Wrench body = robot_.ask(robot_.panel.arm.body_measured_cf);
  ASSERT_TRUE(body.valid);
  EXPECT_LT((body.force - goal.force).norm(), 0.02) << body.force.transpose();
}

TEST(ReleasedPsm, StaysOrFallsByItsMotors) {
  Psm psm(PsmParameters{});
  PsmDrives drives({.permit = {}, .dynamics = DriveDynamics::RigidBody});
  Robot robot(psm, drives);
  const auto pitch = [&] { return psm.motion().measured_js().position[1]; };
  const double before = pitch();
  EXPECT_TRUE(robot.panel.arm.free());
  pass(2s);
  EXPECT_NEAR(pitch(), before, 1e-3);
  EXPECT_TRUE(robot.panel.arm.use_gravity_compensation(false));
  pass(2s);
  EXPECT_GT(std::abs(pitch() - before), 0.05);
  EXPECT_EQ(psm.operating_state().state, ArmState::Enabled);
}

// Joints without mass have no motors to push with.
TEST(LaggingMtm, AnEffortMovesButDoesNotRelease) {
  Mtm mtm(MtmParameters{});
  MtmDrives drives({.permit = {}});
  Robot robot(mtm, drives);
  const double before = mtm.motion().setpoint_js().position[0];
  JointEffortGoal goal;
  goal.effort = {0.5, 0, 0, 0, 0, 0, 0};
  robot.stream(200ms, [&] { return robot.panel.arm.servo_jf(goal); });
  EXPECT_NEAR(mtm.motion().setpoint_js().position[0] - before, 0.05, 0.01);
}

}  // namespace
}  // namespace robots::test
