#pragma once
// This is a teleoperation between two arms that a test places, with an operator who sets it.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/manager/manager.h>
#include <suture/standard/messages.suture.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "integration/teleoperation/scene/scripted_arm.h"
#include "integration/teleoperation/scene/test_console.h"
#include "registration/registration_table.h"
#include "support/pass.h"
#include "support/stepped.h"
#include "teleop/teleop.h"

namespace robots::test {

using namespace std::chrono_literals;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using suture::pass;

inline Isometry3d poseAt(const Vector3d& position, double angle) {
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() = position;
  pose.rotate(Eigen::AngleAxisd(angle, Vector3d::UnitZ()));
  return pose;
}

/// Sets the teleoperation as an operator does, and keeps what it tells.
class Operator final : public suture::Device {
 public:
  Operator() {
    teleop.on().teleop_state([this](const TeleopState& state) { states.push_back(state); });
    messages.on().error([this](const suture::Message& message) { error = message.text; });
  }

  /// Returns the states as far as they have been told by now.
  std::vector<TeleopState> told() {
    EXPECT_TRUE(processEvents());
    return states;
  }
  TeleopState state() { return told().empty() ? TeleopState::Disabled : states.back(); }

  suture::Required<Teleoperation> teleop{*this, "Teleoperation"};
  suture::Required<suture::Messages> messages{*this, "Messages"};
  suture::Required<Registration> registration{*this, "Registration"};
  std::vector<TeleopState> states;
  std::string error;
};

/// The arms stand still but for what the test has them do.
class TeleopStates : public testing::Test {
 protected:
  TeleopStates() {
    master_.place(poseAt({0.1, 0, 0}, 0.2));
    slave_.place(poseAt({0.3, 0, 0}, -0.4));
  }
  ~TeleopStates() override { manager_.stop(); }

  /// The teleoperation's required interface `name` is connected only when the test says so.
  void leaveForLater(const std::string& name) { later_ = name; }
  void connectWhatWasLeft() { connect(later_); }

  void start(const TeleopParameters& parameters = {.scale = 0.5}) {
    teleop_ = std::make_unique<Teleop>(parameters);
    teleop_->restartAfterFaults({.most = 1, .per = 24h});
    manager_.add("MTM", master_);
    manager_.add("PSM", slave_);
    manager_.add("Console", console_);
    manager_.add("Registration", registration_);
    manager_.add("Teleop", *teleop_);
    manager_.add("Operator", operator_);
    manager_.connect("Operator/Teleoperation", "Teleop/Teleoperation");
    manager_.connect("Operator/Messages", "Teleop/Messages");
    manager_.connect("Operator/Registration", "Registration/Registration");
    for (suture::RequiredBase* const required : teleop_->required()) {
      if (required->name() == later_) required->expectConnection();
    }
    for (const char* const name : {"Registration", "Pedals", "Presence"}) {
      if (name != later_) connect(name);
    }
    manager_.connect("Teleop/Master", "MTM/Arm");
    manager_.connect("Teleop/Slave", "PSM/Arm");
    manager_.start();
  }
  bool reaches(TeleopState state) {
    return suture::clockOfTest().until([&] { return operator_.state() == state; });
  }
  void startFollowing() {
    start();
    ASSERT_TRUE(reaches(TeleopState::Following));
    pass(5ms);
  }
  /// Returns the way of the slave while the master goes so far, in the base frames of each.
  Vector3d wayOfSlave(const Vector3d& wayOfMaster) {
    const Vector3d before = slave_.pose().translation();
    Isometry3d pose = master_.pose();
    pose.translation() += wayOfMaster;
    master_.place(pose);
    pass(10ms);
    return slave_.pose().translation() - before;
  }
  /// Makes what the registration tells take so much longer from now on.
  void registerLate(suture::Duration delay) {
    manager_.disconnect("Teleop/Registration");
    manager_.connect("Teleop/Registration", "Registration/Registration",
                     {.delay = {.answers = delay}});
  }
  void turnMaster(double angle) {
    master_.place(master_.pose() * Eigen::AngleAxisd(angle, Vector3d::UnitZ()));
    pass(10ms);
  }
  /// The slave holds, and the master moves without it, until `resume()`; then it follows from
  /// where it is.
  template <class Resume>
  void expectClutchedUntil(const Resume& resume) {
    ASSERT_TRUE(reaches(TeleopState::Clutched));
    pass(5ms);
    EXPECT_EQ(slave_.holds(), 1u);
    EXPECT_EQ(wayOfSlave({0.2, 0.1, 0}), Vector3d::Zero());
    resume();
    ASSERT_TRUE(reaches(TeleopState::Following));
    pass(5ms);
    EXPECT_TRUE(slave_.pose().isApprox(poseAt({0.3, 0, 0}, -0.4), 1e-9)) << "it jumped";
    EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0.05, 0, 0), 1e-9));
  }

  ScriptedArm master_, slave_;
  TestConsole console_;
  RegistrationTable registration_{SceneFrames{}};  // as all are one, the surgeon sees what is there
  std::unique_ptr<Teleop> teleop_;
  Operator operator_;
  suture::Manager manager_{"console"};

 private:
  void connect(const std::string& name) {
    const bool isRegistered = name == "Registration";
    manager_.connect("Teleop/" + name, (isRegistered ? "Registration/" : "Console/") + name);
  }

  std::string later_;
};

}  // namespace robots::test
