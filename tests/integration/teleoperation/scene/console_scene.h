#pragma once
// This is a console with a master, a slave and their teleoperation, and somebody who looks at them.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/manager/manager.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "console/system_console.h"
#include "coordinator/coordinator.h"
#include "integration/teleoperation/scene/driven_arm.h"
#include "support/pass.h"
#include "support/stepped.h"
#include "teleop/teleop.h"

namespace robots::test {

using namespace std::chrono_literals;
using suture::pass;
using Names = std::vector<std::string>;

/// Looks at the console, and notes what it and its arms become.
struct Onlooker final : suture::Device {
  Onlooker() {
    console.on().console_state([this](const ConsoleState& state) { states.push_back(state); });
    console.on().error([this](const suture::Message& error) { errors.push_back(error.text); });
    console.on().warning([this](const suture::Message& news) { warnings.push_back(news.text); });
    note(master, "MTML");
    note(slave, "PSM2");
    teleop.on().teleop_state([this](const TeleopState& state) {
      if (state == TeleopState::Preparing) order.emplace_back("Teleop prepares");
      if (state == TeleopState::Disabled) order.emplace_back("Teleop disabled");
    });
  }
  void note(suture::Required<Arm>& arm, const std::string& name) {
    arm.on().operating_state([this, name](const OperatingState& state) {
      if (state.state == ArmState::Disabled) order.push_back(name + " disabled");
      if (state.state == ArmState::Enabled && !state.is_homed && !state.is_busy) {
        order.push_back(name + " enabled");
      }
      if (state.sub_state == "homing") order.push_back(name + " homing");
    });
  }

  suture::Required<Console> console{*this, "Console"};
  suture::Required<EmergencyStop> button{*this, "Stop"};
  suture::Required<Arm> master{*this, "Master"}, slave{*this, "Slave"};
  suture::Required<Teleoperation> teleop{*this, "Teleop"};
  std::vector<ConsoleState> states;
  Names errors, warnings, order;
};

class ConsoleTest : public testing::Test {
 protected:
  ~ConsoleTest() override { manager_.stop(); }

  static SystemConsoleParameters console(bool byItself) {
    return {.system = {"MTML", "PSM2", "TeleopL"}, .patience = 3s, .bring_up_by_itself = byItself};
  }
  void begin(bool byItself = false) {
    add(byItself);
    start();
  }
  void add(bool byItself) {
    console_.emplace(console(byItself));
    manager_.add("Coordinator", coordinator_);
    master_.addTo(manager_, "MTML");
    slave_.addTo(manager_, "PSM2");
    manager_.add("TeleopL", teleop_);
    manager_.add("Console", *console_);
    manager_.add("Onlooker", onlooker_);
    manager_.connect("TeleopL/Master", "MTML/Arm");
    manager_.connect("TeleopL/Slave", "PSM2/Arm");
    for (const char* const one : {"MTMLDrives", "PSM2Drives", "Onlooker"}) {
      manager_.connect(one + std::string("/Stop"), "Coordinator/Stop");
    }
    connectConsole("Console");
    manager_.connect("Onlooker/Master", "MTML/Arm");
    manager_.connect("Onlooker/Slave", "PSM2/Arm");
    manager_.connect("Onlooker/Teleop", "TeleopL/Teleoperation");
  }
  void start() {
    manager_.start();
    pass(50ms);
  }
  /// The onlooker looks at this console from now on.
  void connectConsole(const std::string& name) {
    manager_.connect("Onlooker/Console", name + "/Console");
    manager_.connect(name + "/Stop", "Coordinator/Stop");
    manager_.connect(name + "/MTML", "MTML/Arm");
    manager_.connect(name + "/PSM2", "PSM2/Arm");
    manager_.connect(name + "/TeleopL", "TeleopL/Teleoperation");
  }
  void release() {
    pass(5ms);  // until permits tell of the last press
    EXPECT_TRUE(onlooker_.button.release(coordinator_.permit().press));
    pass(50ms);
  }
  /// Makes the slave's drives say nothing for too long.
  void failSlave() {
    manager_.suspend("PSM2Drives");
    EXPECT_TRUE(suture::clockOfTest().until([&] { return slaveState() == ArmState::Fault; }));
    manager_.resume("PSM2Drives");
    pass(100ms);
  }
  ArmState masterState() const { return master_.arm.operating_state().state; }
  ArmState slaveState() const { return slave_.arm.operating_state().state; }
  void bringUp() { EXPECT_TRUE(onlooker_.console.bring_up()); }
  bool becomes(ConsoleState wanted) {
    return suture::clockOfTest().until([&] {
      onlooker_.processEvents();
      return console_->console_state() == wanted;
    });
  }
  void bringUpUntil(ConsoleState wanted) {
    release();
    bringUp();
    ASSERT_TRUE(becomes(wanted));
  }
  /// The slave is on its way home, as the console has asked it to be.
  bool slaveHomes() {
    begin();
    bringUpUntil(ConsoleState::Homing);
    return suture::clockOfTest().until([&] { return slave_.arm.operating_state().is_busy; });
  }
  /// The console gives up for that reason, and disables what it has enabled.
  void expectTakenBack(const std::string& why) {
    ASSERT_TRUE(becomes(ConsoleState::Down));
    pass(5s);
    look();
    EXPECT_EQ(onlooker_.errors, Names{why + "; all is taken back"});
    EXPECT_EQ(masterState(), ArmState::Disabled);
  }
  void look() {
    pass(50ms);
    onlooker_.processEvents();
  }

  Coordinator coordinator_{CoordinatorParameters{}};
  DrivenMtm master_{Side::Left, 30ms};
  DrivenPsm slave_{30ms};
  Teleop teleop_{TeleopParameters{.enable_at_start = false}};
  std::optional<SystemConsole> console_;
  Onlooker onlooker_;
  suture::Manager manager_{"workstation"};
};

}  // namespace robots::test
