// Arms whose drives simulate joints with mass, as a deployment has them.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/manager/manager.h>

#include <chrono>
#include <cmath>

#include "arm_control/mtm.h"
#include "arm_control/psm.h"
#include "drives/mtm_drives.h"
#include "drives/psm_drives.h"
#include "support/pass.h"
#include "support/stepped.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using suture::pass;

struct Panel final : suture::Device {
  suture::Required<Arm> arm{*this, "Arm"};
};

/// Enables `arm` in a process with `drives`, moves its first joint there, and tells how far it
/// came.
template <class AnArm, class Drives>
double movedBy(double goal, AnArm& arm, Drives& drives) {
  Panel panel;
  suture::Manager manager("robot");
  manager.add("Arm", arm);
  manager.add("Drives", drives);
  manager.add("Panel", panel);
  manager.connect("Arm/Drives", "Drives/Drives");
  manager.connect("Panel/Arm", "Arm/Arm");
  manager.start();
  const auto becomes = [&](ArmState wanted) {
    return suture::clockOfTest().until([&] { return arm.operating_state().state == wanted; });
  };
  EXPECT_TRUE(becomes(ArmState::Disabled));
  EXPECT_TRUE(panel.arm.enable());
  EXPECT_TRUE(becomes(ArmState::Enabled));
  pass(10ms);
  const double before = drives.feedback().position[0];
  const auto& present = arm.setpoint_js().position;
  JointGoal there{{present.begin(), present.end()}, suture::now()};
  there.position[0] += goal;
  EXPECT_TRUE(panel.arm.move_jp(there));
  pass(2s);
  EXPECT_EQ(drives.feedback().power, DrivePower::On);
  EXPECT_EQ(arm.operating_state().state, ArmState::Enabled);
  manager.stop();
  return drives.feedback().position[0] - before;
}

TEST(HeavyArm, PsmGoesWhereItIsSent) {
  Psm psm(PsmParameters{});
  PsmDrives drives(
      {.permit = {}, .dynamics = DriveDynamics::RigidBody, .rigid_body = {.noise = 1}});
  EXPECT_NEAR(movedBy(0.2, psm, drives), 0.2, 0.001);
}

TEST(HeavyArm, MtmGoesWhereItIsSent) {
  Mtm mtm(MtmParameters{});
  MtmDrives drives(
      {.permit = {}, .dynamics = DriveDynamics::RigidBody, .rigid_body = {.noise = 1}});
  EXPECT_NEAR(movedBy(0.2, mtm, drives), 0.2, 0.001);
}

// Its joints do not follow exactly, as encoders tell counts; joints that lag would.
TEST(HeavyArm, IsWhatTheParameterChooses) {
  Psm psm(PsmParameters{});
  PsmDrives heavy({.permit = {}, .dynamics = DriveDynamics::RigidBody});
  EXPECT_GT(std::abs(movedBy(0.2, psm, heavy) - 0.2), 1e-5);
  Psm another(PsmParameters{});
  PsmDrives lagging({.permit = {}});
  EXPECT_LT(std::abs(movedBy(0.2, another, lagging) - 0.2), 1e-9);
}

}  // namespace
}  // namespace robots::test
