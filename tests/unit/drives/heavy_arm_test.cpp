// These arms have drives that simulate joints with mass, as a deployment has them.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <vector>

#include "arm_control/mtm.h"
#include "arm_control/psm.h"
#include "drives/mtm_drives.h"
#include "drives/psm_drives.h"
#include "dynamics/davinci_inertia.h"
#include "support/pass.h"
#include "unit/drives/robot_in_process.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using suture::pass;

TEST(HeavyArm, PsmGoesWhereItIsSent) {
  Psm psm(PsmParameters{});
  PsmDrives drives(
      {.permit = {}, .dynamics = DriveDynamics::RigidBody, .rigid_body = {.noise = 1}});
  Robot robot(psm, drives);
  EXPECT_NEAR(robot.move(0.2), 0.2, 0.001);
}

TEST(HeavyArm, MtmGoesWhereItIsSent) {
  Mtm mtm(MtmParameters{});
  MtmDrives drives(
      {.permit = {}, .dynamics = DriveDynamics::RigidBody, .rigid_body = {.noise = 1}});
  Robot robot(mtm, drives);
  EXPECT_NEAR(robot.move(0.2), 0.2, 0.001);
}

// Its joints do not follow exactly, as encoders tell counts; joints that lag would.
TEST(HeavyArm, IsWhatTheParameterChooses) {
  Psm psm(PsmParameters{});
  PsmDrives heavy({.permit = {}, .dynamics = DriveDynamics::RigidBody});
  EXPECT_GT(std::abs(Robot(psm, heavy).move(0.2) - 0.2), 1e-5);
  Psm another(PsmParameters{});
  PsmDrives lagging({.permit = {}});
  EXPECT_LT(std::abs(Robot(another, lagging).move(0.2) - 0.2), 1e-9);
}

// Its motors carry it, and rub. The weight is no force at its tip, and friction is none either, but
// friction cannot be told from one.
TEST(HeavyArm, PressesNoHarderThanItsFriction) {
  Psm psm(PsmParameters{});
  PsmDrives drives({.permit = {}, .dynamics = DriveDynamics::RigidBody});
  Robot robot(psm, drives);
  robot.move(0.2);
  const Wrench force = robot.ask(robot.panel.arm.spatial_measured_cf);
  ASSERT_TRUE(force.valid);
  const Jacobian jacobian = robot.ask(robot.panel.arm.spatial_jacobian);
  ASSERT_TRUE(jacobian.valid);
  kinematics::SpatialVector wrench;
  wrench << force.force, force.torque;
  const Eigen::Map<const Eigen::Matrix<double, 6, 6>> matrix(jacobian.coefficients.data());
  const Eigen::Matrix<double, 6, 1> pressing = matrix.transpose() * wrench;
  const auto mechanics = dynamics::psmMechanics();
  for (int i = 0; i < 6; ++i) {
    EXPECT_LT(std::abs(pressing[i]), 1.01 * mechanics.coulomb[i]) << "joint " << i;
  }
  const std::vector<double>& efforts = psm.motion().measured_js().effort;
  ASSERT_EQ(efforts.size(), 6u);
  EXPECT_GT(std::abs(efforts[1]), 2 * mechanics.coulomb[1]) << "it is the weight that is much";
}

TEST(HeavyArm, SinksWithoutBrakesWhenDisabled) {
  Mtm mtm(MtmParameters{});
  MtmDrives drives(
      {.permit = {}, .dynamics = DriveDynamics::RigidBody, .rigid_body = {.brakes = false}});
  Robot robot(mtm, drives);
  const auto shoulder = [&] { return mtm.motion().measured_js().position[1]; };
  const double before = shoulder();
  EXPECT_TRUE(robot.panel.arm.disable());
  pass(1s);
  EXPECT_EQ(drives.feedback().power, DrivePower::Off);
  EXPECT_GT(std::abs(shoulder() - before), 0.02);
  EXPECT_TRUE(robot.panel.arm.enable());
  pass(1s);
  const double held = shoulder();
  pass(1s);
  EXPECT_EQ(drives.feedback().power, DrivePower::On);
  EXPECT_NEAR(shoulder(), held, 1e-3);
}

// The effort that carries its weight seems to be more than its motors can give.
TEST(HeavyArm, TooHighSensorsPutItInFault) {
  Psm psm(PsmParameters{});
  PsmDrives drives(
      {.permit = {}, .dynamics = DriveDynamics::RigidBody, .rigid_body = {.current_gain = 50}});
  Robot robot(psm, drives);
  pass(200ms);
  EXPECT_EQ(psm.operating_state().state, ArmState::Fault);
  EXPECT_EQ(psm.operating_state().sub_state, "over-current");
  EXPECT_EQ(drives.feedback().power, DrivePower::Off);
}

TEST(LaggingArm, MeasuresNoForce) {
  Psm psm(PsmParameters{});
  PsmDrives drives({.permit = {}});
  Robot robot(psm, drives);
  robot.move(0.2);
  EXPECT_FALSE(robot.ask(robot.panel.arm.spatial_measured_cf).valid);
  EXPECT_TRUE(psm.motion().measured_js().effort.empty());
}

}  // namespace
}  // namespace robots::test
