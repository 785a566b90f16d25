#pragma once
// This is an arm with its drives in a process, for tests that step its time.

#include <gtest/gtest.h>
#include <suture/base/errors.h>
#include <suture/component/device.h>
#include <suture/manager/manager.h>

#include <chrono>
#include <string>
#include <vector>

#include "arm/arm.suture.h"
#include "arm/arm_warning.h"
#include "drives/drives.h"
#include "support/pass.h"
#include "support/stepped.h"

namespace robots::test {

using namespace std::chrono_literals;

/// Uses the arm, and keeps the errors that it tells.
struct Panel final : suture::Device {
  Panel() {
    arm.on().error([this](const suture::Message& error) {
      codes.push_back(static_cast<ArmWarning>(error.code));
      texts.push_back(error.text);
    });
  }
  suture::Required<Arm> arm{*this, "Arm"};
  std::vector<ArmWarning> codes;
  std::vector<std::string> texts;
};

/// A Robot is an enabled arm in a process with its drives.
template <class AnArm, class Drives>
class Robot {
 public:
  Robot(AnArm& arm, Drives& drives) : arm_(arm), drives_(drives) {
    manager_.add("Arm", arm);
    manager_.add("Drives", drives);
    manager_.add("Panel", panel);
    manager_.connect("Arm/Drives", "Drives/Drives");
    manager_.connect("Panel/Arm", "Arm/Arm");
    manager_.start();
    EXPECT_TRUE(becomes(ArmState::Disabled));
    EXPECT_TRUE(panel.arm.enable());
    EXPECT_TRUE(becomes(ArmState::Enabled));
    suture::pass(10ms);
  }
  ~Robot() { manager_.stop(); }

  /// Moves the first joint there, and tells how far it came.
  double move(double by) {
    const double before = drives_.feedback().position[0];
    const auto& present = arm_.motion().setpoint_js().position;
    JointGoal there{{present.begin(), present.end()}, suture::now()};
    there.position[0] += by;
    EXPECT_TRUE(panel.arm.move_jp(there));
    suture::pass(2s);
    EXPECT_EQ(drives_.feedback().power, DrivePower::On);
    EXPECT_EQ(state(), ArmState::Enabled);
    return drives_.feedback().position[0] - before;
  }

  /// Returns what the arm answers now.
  template <class Read>
  auto ask(Read& read) {
    auto call = read.fresh();
    const auto& sample = call.within(10s);
    EXPECT_TRUE(sample) << suture::toString(sample.error());
    return *sample;
  }

  /// Sends a command again every 10 ms for so long, as a stream of goals.
  template <class Command>
  void stream(suture::Duration duration, const Command& command) {
    for (suture::Duration t{0}; t < duration; t += 10ms) {
      EXPECT_TRUE(command());
      suture::pass(10ms);
    }
  }

  ArmState state() { return arm_.operating_state().state; }
  bool becomes(ArmState wanted) {
    return suture::clockOfTest().until([&] { return state() == wanted; });
  }

  Panel panel;

 private:
  AnArm& arm_;
  Drives& drives_;
  suture::Manager manager_{"robot"};
};

}  // namespace robots::test
