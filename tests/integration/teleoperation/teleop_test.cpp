// These say when the teleoperation task follows, when it stops, and how it begins again.

#include <gtest/gtest.h>
#include <suture/base/errors.h>

#include "coordinator/coordinator.h"
#include "integration/teleoperation/scene/workstation.h"

namespace robots::test {
namespace {

bool reaches(Workstation& station, TeleopState state) {
  return suture::eventually([&] { return ask(station.client.teleop.teleop_state) == state; });
}

ArmState slaveState(Workstation& station) {
  return ask(station.client.slave.operating_state).state;
}

TEST(Teleop, PreparesBothArmsAndFollows) {
  Workstation station({.scale = 0.4});
  station.manager.start();
  ASSERT_TRUE(reaches(station, TeleopState::Following));
  const FollowAnchors anchors = ask(station.client.teleop.anchors);
  EXPECT_EQ(anchors.entry, 1u);
  EXPECT_EQ(anchors.scale, 0.4);
  EXPECT_TRUE(ask(station.client.slave.operating_state).is_homed);
  EXPECT_TRUE(ask(station.client.master.operating_state).is_homed);
  EXPECT_TRUE(suture::eventually([&] {
    const PoseStamped tip = ask(station.client.slave.measured_cp);
    return (tip.pose.translation() - anchors.slave_setpoint.translation()).norm() > 0.02;
  })) << "the surgeon moves the master; the slave does not follow";
}

TEST(Teleop, WaitsForEnable) {
  Workstation station({.enable_at_start = false});
  station.manager.start();
  ASSERT_TRUE(cyclesPass(station.teleop, 50));
  EXPECT_EQ(ask(station.client.teleop.teleop_state), TeleopState::Disabled);
  EXPECT_EQ(slaveState(station), ArmState::Disabled);
  ASSERT_TRUE(station.client.teleop.enable());
  EXPECT_TRUE(reaches(station, TeleopState::Following));
}

// An operator disables the slave: following ends, and only an operator may begin it again.
TEST(Teleop, RespectsAnArmThatIsTakenAway) {
  Workstation station({.scale = 0.4});
  station.manager.start();
  ASSERT_TRUE(reaches(station, TeleopState::Following));
  ASSERT_TRUE(station.client.slave.disable());
  ASSERT_TRUE(reaches(station, TeleopState::Preparing));
  ASSERT_TRUE(cyclesPass(station.teleop, 100));
  EXPECT_EQ(slaveState(station), ArmState::Disabled);
  EXPECT_EQ(ask(station.client.teleop.teleop_state), TeleopState::Preparing);

  const PoseStamped before = ask(station.client.slave.setpoint_cp);
  ASSERT_TRUE(station.client.teleop.enable());
  ASSERT_TRUE(reaches(station, TeleopState::Following));
  const FollowAnchors anchors = ask(station.client.teleop.anchors);
  EXPECT_EQ(anchors.entry, 2u);
  EXPECT_TRUE(anchors.slave_setpoint.isApprox(before.pose, 1e-9)) << "the slave jumped";
}

/// Lets somebody else bring the slave and the master up, as a console does, and then enables a
/// teleoperation that has nothing left to ask for.
void followArmsThatAreUp(Workstation& station) {
  station.manager.start();
  suture::Required<Arm>* const arms[] = {&station.client.master, &station.client.slave};
  for (suture::Required<Arm>* const arm : arms) {
    ASSERT_TRUE(
        suture::eventually([&] { return ask(arm->operating_state).state == ArmState::Disabled; }));
    ASSERT_TRUE(arm->enable());
    ASSERT_TRUE(
        suture::eventually([&] { return ask(arm->operating_state).state == ArmState::Enabled; }));
    ASSERT_TRUE(arm->home());
    ASSERT_TRUE(suture::eventually([&] {
      const OperatingState state = ask(arm->operating_state);
      return state.is_homed && !state.is_busy;
    }));
  }
  ASSERT_TRUE(station.client.teleop.enable());
  ASSERT_TRUE(reaches(station, TeleopState::Following));
}

TEST(Teleop, DisablesNoArmThatItFoundEnabled) {
  Workstation station({.enable_at_start = false});
  ASSERT_NO_FATAL_FAILURE(followArmsThatAreUp(station));
  ASSERT_TRUE(station.client.slave.disable());
  ASSERT_TRUE(reaches(station, TeleopState::Preparing));
  ASSERT_TRUE(cyclesPass(station.teleop, 500));
  EXPECT_EQ(slaveState(station), ArmState::Disabled);
  ASSERT_TRUE(station.client.teleop.enable());
  EXPECT_TRUE(reaches(station, TeleopState::Following)) << "an operator has decided it";
}

TEST(Teleop, HomesNoArmThatItFoundHomed) {
  Workstation station({.enable_at_start = false});
  ASSERT_NO_FATAL_FAILURE(followArmsThatAreUp(station));
  ASSERT_TRUE(station.client.slave.unhome());
  ASSERT_TRUE(reaches(station, TeleopState::Preparing));
  ASSERT_TRUE(cyclesPass(station.teleop, 500));
  const OperatingState state = ask(station.client.slave.operating_state);
  EXPECT_FALSE(state.is_homed || state.is_busy);
  ASSERT_TRUE(station.client.teleop.enable());
  EXPECT_TRUE(reaches(station, TeleopState::Following)) << "an operator has decided it";
}

/// Releases the emergency stop, as an operator does.
struct StopButton final : suture::Device {
  suture::Required<EmergencyStop> stop{*this, "Stop"};
};

// A coordinator that is suspended takes the slave's power.
TEST(Teleop, LeavesAnArmDisabledWhosePermitLapsed) {
  Coordinator coordinator{CoordinatorParameters{}};
  StopButton button;
  Workstation station({.scale = 0.4}, std::chrono::milliseconds(30));
  station.manager.add("Coordinator", coordinator);
  station.manager.add("Button", button);
  station.manager.connect("PSMDrives/Stop", "Coordinator/Stop");
  station.manager.connect("Button/Stop", "Coordinator/Stop");
  station.manager.start();
  ASSERT_TRUE(suture::eventually([&] { return coordinator.permit().press != 0; }));
  const std::uint64_t first = coordinator.permit().press;
  ASSERT_TRUE(button.stop.release(first));
  ASSERT_TRUE(reaches(station, TeleopState::Following));

  station.manager.suspend("Coordinator");
  ASSERT_TRUE(suture::eventually([&] { return slaveState(station) == ArmState::Disabled; }));
  station.manager.resume("Coordinator");
  ASSERT_TRUE(suture::eventually([&] { return coordinator.permit().press != first; }));
  ASSERT_TRUE(button.stop.release(coordinator.permit().press));
  ASSERT_TRUE(
      suture::eventually([&] { return station.psm.drives.feedback().power == DrivePower::Off; }));
  ASSERT_TRUE(cyclesPass(station.teleop, 500));
  EXPECT_EQ(slaveState(station), ArmState::Disabled);
  EXPECT_EQ(ask(station.client.teleop.teleop_state), TeleopState::Preparing);
  ASSERT_TRUE(station.client.teleop.enable());
  EXPECT_TRUE(reaches(station, TeleopState::Following)) << "an operator has decided it";
}

/// An operator who enables arms that are up decides nothing about a disable that comes later.
TEST(Teleop, ASecondEnableDisablesNoArm) {
  Workstation station({.scale = 0.4});
  station.manager.start();
  ASSERT_TRUE(reaches(station, TeleopState::Following));
  ASSERT_TRUE(station.client.teleop.enable());
  ASSERT_TRUE(cyclesPass(station.teleop, 5));
  ASSERT_TRUE(station.client.slave.disable());
  ASSERT_TRUE(reaches(station, TeleopState::Preparing));
  ASSERT_TRUE(cyclesPass(station.teleop, 500));
  EXPECT_EQ(slaveState(station), ArmState::Disabled);
}

TEST(Teleop, DisableLeavesTheSlaveWhereItIs) {
  Workstation station({.scale = 0.4});
  station.manager.start();
  ASSERT_TRUE(reaches(station, TeleopState::Following));
  ASSERT_TRUE(station.client.teleop.disable());
  ASSERT_TRUE(reaches(station, TeleopState::Disabled));
  ASSERT_TRUE(cyclesPass(station.psm.arm, 3));  // whatever was under way has arrived
  const PoseStamped before = ask(station.client.slave.setpoint_cp);
  ASSERT_TRUE(cyclesPass(station.psm.arm, 50));
  EXPECT_TRUE(ask(station.client.slave.setpoint_cp).pose.isApprox(before.pose, 1e-12));
  EXPECT_EQ(slaveState(station), ArmState::Enabled);
}

TEST(Teleop, RefusesAnImpossibleAge) {
  using namespace std::chrono_literals;
  for (const suture::Duration age : {suture::Duration(-5ms), suture::Duration(0),
                                     suture::Duration(std::chrono::seconds(1'000'000'000))}) {
    EXPECT_THROW(Teleop({.max_age = age}), suture::SetupError);
    EXPECT_THROW(Teleop({.operator_age = age}), suture::SetupError);
    EXPECT_THROW(Teleop({.registration_age = age}), suture::SetupError);
  }
}

TEST(Teleop, RefusesANonPositiveScale) {
  for (const double scale : {0.0, -0.2}) {
    try {
      Teleop teleop({.scale = scale});
      FAIL() << "scale " << scale << " was accepted";
    } catch (const suture::SetupError& error) {
      EXPECT_NE(std::string(error.what()).find("above zero"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace robots::test
