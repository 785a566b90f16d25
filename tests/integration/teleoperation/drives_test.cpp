// An arm and its drives have a task each, and one of the two stands still.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/manager/manager.h>

#include <chrono>
#include <stdexcept>
#include <vector>

#include "arm/arm_warning.h"
#include "coordinator/coordinator.h"
#include "integration/teleoperation/scene/driven_arm.h"
#include "support/pass.h"
#include "support/stepped.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using suture::pass;

class DrivenArmTest : public testing::Test {
 protected:
  struct Panel final : suture::Device {
    Panel() {
      arm.on().error([this](const suture::Message& said) {
        codes.push_back(static_cast<ArmWarning>(said.code));
      });
    }
    suture::Required<Arm> arm{*this, "Arm"};
    suture::Required<EmergencyStop> button{*this, "Stop"};
    std::vector<ArmWarning> codes;
  };

  DrivenArmTest() {
    psm_.drives.restartAfterFaults({.most = 1, .per = 24h});
    psm_.addTo(manager_, "PSM");
    manager_.add("Coordinator", coordinator_);
    manager_.add("Panel", panel_);
    manager_.connect("Panel/Arm", "PSM/Arm");
    manager_.start();
    EXPECT_TRUE(becomes(ArmState::Disabled));
    EXPECT_TRUE(panel_.arm.enable());
    EXPECT_TRUE(becomes(ArmState::Enabled));
    pass(10ms);
  }
  ~DrivenArmTest() override { manager_.stop(); }

  ArmState state() { return psm_.arm.operating_state().state; }
  bool becomes(ArmState wanted) {
    return suture::clockOfTest().until([&] { return state() == wanted; });
  }
  double joint() { return psm_.drives.feedback().position[0]; }
  void move(double by) {
    const auto& present = psm_.arm.motion().setpoint_js().position;
    JointGoal goal{{present.begin(), present.end()}, suture::now()};
    goal.position[0] += by;
    EXPECT_TRUE(panel_.arm.move_jp(goal));
  }

  Coordinator coordinator_{CoordinatorParameters{}};
  DrivenPsm psm_;
  Panel panel_;
  suture::Manager manager_{"robot"};
};

TEST_F(DrivenArmTest, RestartedDrivesWaitForEnable) {
  psm_.drives.parkSoonOnThrow([] { throw std::runtime_error("a loose contact"); });
  ASSERT_TRUE(becomes(ArmState::Disabled));
  pass(100ms);
  EXPECT_EQ(psm_.drives.state(), suture::ComponentState::Running) << "they were restarted";
  EXPECT_EQ(psm_.drives.feedback().power, DrivePower::Off);
  EXPECT_TRUE(panel_.arm.enable());
  EXPECT_TRUE(becomes(ArmState::Enabled));
  pass(10ms);
  EXPECT_EQ(psm_.drives.feedback().power, DrivePower::On);
}

TEST_F(DrivenArmTest, MovesWhatItsDrivesMove) {
  const double before = joint();
  move(0.2);
  pass(1s);
  EXPECT_NEAR(joint(), before + 0.2, 1e-4);
  EXPECT_EQ(psm_.drives.feedback().power, DrivePower::On);
  EXPECT_TRUE(panel_.arm.disable());
  pass(5ms);
  EXPECT_EQ(psm_.drives.feedback().power, DrivePower::Off);
}

TEST_F(DrivenArmTest, AHungArmLeavesItsJoints) {
  move(1);
  pass(300ms);
  manager_.suspend("PSM");
  pass(150ms);
  const double held = joint();
  EXPECT_LT(held, 1);
  pass(300ms);
  EXPECT_EQ(joint(), held);
}

TEST_F(DrivenArmTest, IsInFaultWhenItsDrivesHang) {
  manager_.suspend("PSMDrives");
  pass(200ms);
  EXPECT_EQ(state(), ArmState::Enabled) << "that may be a pause";
  pass(100ms);
  EXPECT_EQ(state(), ArmState::Fault);
  panel_.processEvents();
  EXPECT_EQ(panel_.codes, std::vector{ArmWarning::DrivesSilent});
}

TEST_F(DrivenArmTest, StopsThoughItNeedsNoPermit) {
  manager_.connect("PSMDrives/Stop", "Coordinator/Stop");
  EXPECT_TRUE(becomes(ArmState::Disabled)) << "the coordinator starts pressed";
  EXPECT_EQ(psm_.drives.feedback().power, DrivePower::Stopped);
  manager_.connect("Panel/Stop", "Coordinator/Stop");
  EXPECT_TRUE(panel_.button.release(coordinator_.permit().press));
  pass(50ms);
  EXPECT_EQ(psm_.drives.feedback().power, DrivePower::Off) << "an arm has to be enabled";
  EXPECT_TRUE(panel_.arm.enable());
  EXPECT_TRUE(becomes(ArmState::Enabled));
  manager_.suspend("Coordinator");
  pass(1s);
  EXPECT_EQ(state(), ArmState::Enabled) << "it needs no permit";
  manager_.resume("Coordinator");
  EXPECT_TRUE(becomes(ArmState::Disabled)) << "somebody may have pressed it meanwhile";
  EXPECT_EQ(psm_.drives.feedback().power, DrivePower::Stopped);
}

/// It cannot tell, for it did not look.
TEST_F(DrivenArmTest, APauseIsNoFault) {
  manager_.suspend("PSM");
  pass(1s);
  manager_.resume("PSM");
  pass(50ms);
  EXPECT_EQ(state(), ArmState::Enabled);
}

}  // namespace
}  // namespace robots::test
