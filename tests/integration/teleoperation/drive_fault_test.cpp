// This arm is over drives whose encoder jumps, or whose motor gives too much.

#include <gtest/gtest.h>
#include <vector>

#include "arm/arm_warning.h"
#include "arm_control/psm.h"
#include "integration/teleoperation/scene/planted_drives.h"
#include "support/pass.h"
#include "unit/drives/robot_in_process.h"

namespace robots::test {
namespace {

using suture::pass;

class PlantedFault : public testing::Test {
 protected:
  /// Returns where the yaw is, and not what is planted.
  double joint() { return drives_.SimulatedDrives::feedback().position[0]; }
  DrivePower power() { return drives_.SimulatedDrives::feedback().power; }
  void expectTold(ArmWarning reason) {
    Panel& panel = robot_.panel;
    panel.processEvents();
    ASSERT_EQ(panel.codes, std::vector{reason});
    EXPECT_EQ(panel.texts[0].find("yaw: "), 0u) << panel.texts[0];
  }

  Psm psm_{PsmParameters{}};
  PlantedDrives drives_;
  Robot<Psm, PlantedDrives> robot_{psm_, drives_};
};

TEST_F(PlantedFault, AnEncoderThatJumps) {
  pass(200ms);
  EXPECT_EQ(robot_.state(), ArmState::Enabled);
  drives_.jump = 0.1;
  pass(5ms);
  EXPECT_EQ(robot_.state(), ArmState::Fault);
  expectTold(ArmWarning::EncoderJump);
  EXPECT_TRUE(robot_.panel.arm.enable());
  EXPECT_TRUE(robot_.becomes(ArmState::Enabled));
}

TEST_F(PlantedFault, AMomentarilyWrongEncoderMovesNoJoint) {
  const double before = joint();
  drives_.jump = 0.1;
  pass(2ms);
  drives_.jump = 0;
  pass(300ms);
  EXPECT_EQ(robot_.state(), ArmState::Fault);
  EXPECT_EQ(power(), DrivePower::Off);
  EXPECT_NEAR(joint(), before, 1e-9);
}

TEST_F(PlantedFault, AMotorThatGivesTooMuch) {
  drives_.effort = 10;
  pass(50ms);
  EXPECT_EQ(robot_.state(), ArmState::Enabled) << "not yet for too long";
  pass(100ms);
  EXPECT_EQ(robot_.state(), ArmState::Fault);
  expectTold(ArmWarning::OverCurrent);
  EXPECT_EQ(power(), DrivePower::Off) << "a motor that gives too much is to give nothing";
  EXPECT_TRUE(robot_.panel.arm.disable());
  EXPECT_TRUE(robot_.becomes(ArmState::Disabled));
}

}  // namespace
}  // namespace robots::test
