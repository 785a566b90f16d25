// A person drives the arms of a deployment.

#include <gtest/gtest.h>
#include <suture/manager/manager.h>

#include <chrono>

#include "integration/person/seat.h"
#include "integration/teleoperation/scene/driven_arm.h"
#include "person/gamepad.h"
#include "support/pass.h"
#include "support/stepped.h"
#include "teleop/teleop.h"
#include "unit/person/fifo.h"
#include "unit/person/recorded_events.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using suture::pass;

class DrivingTest : public testing::Test {
 protected:
  DrivingTest() {
    fifo_.plugIn();
    master_.addTo(manager_, "MTM");
    slave_.addTo(manager_, "PSM");
    manager_.add("Teleop", teleop_);
    manager_.add("Person", gamepad_);
    manager_.connect("Teleop/Master", "MTM/Arm");
    manager_.connect("Teleop/Slave", "PSM/Arm");
    manager_.connect("Teleop/Pedals", "Person/Pedals");
    manager_.connect("Person/Master", "MTM/Arm");
    manager_.connect("Person/Teleoperation", "Teleop/Teleoperation");
    manager_.connect("Person/Hand", "MTMDrives/Hand");
    manager_.start();
  }
  ~DrivingTest() override { manager_.stop(); }

  bool reaches(TeleopState state) {
    const auto reached = [&] { return teleop_.teleop_state() == state; };
    return suture::clockOfTest().until(reached, 30s);
  }
  /// The clutch counts as pressed until the person has pressed and released it.
  void begin() {
    ASSERT_TRUE(reaches(TeleopState::Clutched));
    fifo_.write({button(BTN_TL, true), report(), button(BTN_TL, false), report()});
    ASSERT_TRUE(reaches(TeleopState::Following));
  }
  template <class Arm>
  static Eigen::Vector3d tip(const Arm& driven) {
    return driven.arm.motion().measured_cp().pose.translation();
  }
  void push(const std::vector<input_event>& events, suture::Duration length) {
    fifo_.write(events);
    pass(length);
    fifo_.write(stickReleased());
    pass(200ms);
  }

  Fifo fifo_;
  DrivenMtm master_;
  DrivenPsm slave_;
  Teleop teleop_{{.scale = 0.5}};
  Gamepad gamepad_{{.file = fifo_.path(), .speed = 0.05}};
  suture::Manager manager_{"workstation"};
};

TEST_F(DrivingTest, TheClutchStopsTheSlave) {
  begin();
  pass(100ms);
  const Eigen::Vector3d master = tip(master_), slave = tip(slave_);
  push(stickToTheRight(), 400ms);
  EXPECT_NEAR((tip(master_) - master).norm(), 0.05 * 0.4, 1e-4);
  EXPECT_NEAR((tip(slave_) - slave).norm(), 0.5 * 0.05 * 0.4, 1e-4);

  fifo_.write({button(BTN_TL, true), report()});
  ASSERT_TRUE(reaches(TeleopState::Clutched));
  pass(100ms);
  const Eigen::Vector3d held = tip(slave_);
  push({axis(ABS_X, -32768), report()}, 400ms);
  EXPECT_NEAR((tip(master_) - master).norm(), 0, 1e-4) << "it is back where it was";
  EXPECT_NEAR((tip(slave_) - held).norm(), 0, 1e-6);

  fifo_.write({button(BTN_TL, false), report()});
  ASSERT_TRUE(reaches(TeleopState::Following));
  pass(100ms);
  push(stickToTheRight(), 400ms);
  EXPECT_NEAR((tip(slave_) - held).norm(), 0.5 * 0.05 * 0.4, 1e-4);
}

TEST_F(DrivingTest, TheSlaveRestsWithoutTheGamepad) {
  begin();
  fifo_.pullOut();
  EXPECT_TRUE(reaches(TeleopState::Clutched));
}

}  // namespace
}  // namespace robots::test
