// This arm is over drives whose encoder jumps, or whose motor gives too much.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/manager/manager.h>

#include <chrono>
#include <string>
#include <vector>

#include "arm/arm_warning.h"
#include "arm_control/psm.h"
#include "integration/teleoperation/scene/planted_drives.h"
#include "support/pass.h"
#include "support/stepped.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using suture::pass;

class PlantedFault : public testing::Test {
 protected:
  struct Panel final : suture::Device {
    Panel() {
      arm.on().error([this](const suture::Message& said) {
        codes.push_back(static_cast<ArmWarning>(said.code));
        texts.push_back(said.text);
      });
    }
    suture::Required<Arm> arm{*this, "Arm"};
    std::vector<ArmWarning> codes;
    std::vector<std::string> texts;
  };

  PlantedFault() {
    manager_.add("PSM", psm_);
    manager_.add("Drives", drives_);
    manager_.add("Panel", panel_);
    manager_.connect("PSM/Drives", "Drives/Drives");
    manager_.connect("Panel/Arm", "PSM/Arm");
    manager_.start();
    EXPECT_TRUE(becomes(ArmState::Disabled));
    EXPECT_TRUE(panel_.arm.enable());
    EXPECT_TRUE(becomes(ArmState::Enabled));
    pass(10ms);
  }
  ~PlantedFault() override { manager_.stop(); }

  ArmState state() { return psm_.operating_state().state; }
  bool becomes(ArmState wanted) {
    return suture::clockOfTest().until([&] { return state() == wanted; });
  }
  /// Returns where the yaw is, and not what is planted.
  double joint() { return drives_.SimulatedDrives::feedback().position[0]; }
  DrivePower power() { return drives_.SimulatedDrives::feedback().power; }
  void expectTold(ArmWarning reason) {
    panel_.processEvents();
    ASSERT_EQ(panel_.codes, std::vector{reason});
    EXPECT_EQ(panel_.texts[0].find("yaw: "), 0u) << panel_.texts[0];
  }

  Psm psm_{PsmParameters{}};
  PlantedDrives drives_;
  Panel panel_;
  suture::Manager manager_{"robot"};
};

TEST_F(PlantedFault, AnEncoderThatJumps) {
  pass(200ms);
  EXPECT_EQ(state(), ArmState::Enabled);
  drives_.jump = 0.1;
  pass(5ms);
  EXPECT_EQ(state(), ArmState::Fault);
  expectTold(ArmWarning::EncoderJump);
  EXPECT_TRUE(panel_.arm.enable());
  EXPECT_TRUE(becomes(ArmState::Enabled));
}

TEST_F(PlantedFault, AMomentarilyWrongEncoderMovesNoJoint) {
  const double before = joint();
  drives_.jump = 0.1;
  pass(2ms);
  drives_.jump = 0;
  pass(300ms);
  EXPECT_EQ(state(), ArmState::Fault);
  EXPECT_EQ(power(), DrivePower::Off);
  EXPECT_NEAR(joint(), before, 1e-9);
}

TEST_F(PlantedFault, AMotorThatGivesTooMuch) {
  drives_.effort = 10;
  pass(50ms);
  EXPECT_EQ(state(), ArmState::Enabled) << "not yet for too long";
  pass(100ms);
  EXPECT_EQ(state(), ArmState::Fault);
  expectTold(ArmWarning::OverCurrent);
  EXPECT_EQ(power(), DrivePower::Off) << "a motor that gives too much is to give nothing";
  EXPECT_TRUE(panel_.arm.disable());
  EXPECT_TRUE(becomes(ArmState::Disabled));
}

}  // namespace
}  // namespace robots::test
