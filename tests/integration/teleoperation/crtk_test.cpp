// These use the whole contract of an arm, from another process and from the same one.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <functional>
#include <string>
#include <vector>

#include "arm/arm.suture.h"
#include "integration/teleoperation/scene/workstation.h"
#include "support/patience.h"
#include "support/temporary_directory.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;

struct CrtkClient final : suture::Device {
  CrtkClient() {
    arm.on().goal_reached([this](const bool& reached) { goals.push_back(reached); });
    arm.on().operating_state([this](const OperatingState& now) { state = now.state; });
    arm.on().error([this](const suture::Message& message) { errors.push_back(message.text); });
    arm.on().trajectory_j_ratio([this](const double& value) { ratio = value; });
  }
  suture::Required<Arm> arm{*this, "Arm"};
  ArmState state = ArmState::Undefined;
  std::vector<bool> goals;
  std::vector<std::string> errors;
  double ratio = 0;
};

/// The parameter tells if the arm and its operator share a process.
class Crtk : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    psm_.addTo(here_, "PSM");
    suture::Manager& client = GetParam() ? here_ : there_;
    client.add("Operator", operator_);
    here_.start();
    if (!GetParam()) there_.start();
    client.connect("Operator/Arm", GetParam() ? "PSM/Arm" : "here:PSM/Arm");
    ASSERT_TRUE(heard([this] { return operator_.state == ArmState::Disabled; }));
  }
  void TearDown() override {
    there_.stop();
    here_.stop();
  }
  bool heard(const std::function<bool()>& enough) {
    const suture::Time deadline = suture::now() + suture::kPatience;
    while (!enough() && suture::now() < deadline) operator_.waitForEvents(deadline);
    return enough();
  }

  const suture::TemporaryDirectory directory_;
  suture::loop::ControlThread control_;
  suture::GlobalManager names_{control_, "unix:" + directory_.file("manager.sock")};
  suture::Manager here_{"here", names_.address()};
  suture::Manager there_{"there", names_.address()};
  DrivenPsm psm_;
  CrtkClient operator_;
};

/// A listener of standard messages hears those of an arm.
TEST_P(Crtk, ItsMessagesAreTheStandardOnes) {
  struct Listener final : suture::Device {
    Listener() {
      from.on().warning([this](const suture::Message& message) { warning = message; });
    }
    suture::Required<suture::Messages> from{*this, "From"};
    suture::Message warning;
  } listener;
  suture::Manager& client = GetParam() ? here_ : there_;
  client.add("Listener", listener);
  client.connect("Listener/From", GetParam() ? "PSM/Arm" : "here:PSM/Arm");
  ASSERT_TRUE(operator_.arm.servo_jp(JointGoal{}));
  const suture::Time deadline = suture::now() + suture::kPatience;
  while (listener.warning.counter == 0 && suture::now() < deadline) {
    listener.waitForEvents(deadline);
  }
  EXPECT_NE(listener.warning.text.find("enabled"), std::string::npos) << listener.warning.text;
  client.stop();
}

TEST_P(Crtk, AnOperatorHomesMovesAndAsks) {
  auto& arm = operator_.arm;
  ASSERT_TRUE(arm.state_command.start("enable").within(suture::kPatience));
  ASSERT_TRUE(arm.state_command.start("home").within(suture::kPatience));
  ASSERT_TRUE(heard([&] { return operator_.goals == std::vector<bool>{true}; }));
  EXPECT_TRUE(ask(arm.operating_state).is_homed);

  EXPECT_TRUE(arm.trajectory_j_set_ratio.start(0.5).within(suture::kPatience));
  EXPECT_TRUE(heard([&] { return operator_.ratio == 0.5; }));
  const PoseStamped before = ask(arm.setpoint_cp);
  PoseStamped step;
  step.pose.translation().z() = 0.005;
  step.valid = true;
  EXPECT_TRUE(arm.move_cr.start(step).within(suture::kPatience));
  ASSERT_TRUE(heard([&] { return operator_.goals.size() == 2; }));
  const PoseStamped after = ask(arm.setpoint_cp);
  EXPECT_NEAR(after.pose.translation().z() - before.pose.translation().z(), 0.005, 1e-6);

  const JointGoal q{ask(arm.setpoint_js).position, {}};
  const auto tip = arm.forward_kinematics.start(q).within(suture::kPatience);
  ASSERT_TRUE(tip);
  EXPECT_LT((tip->pose.translation() - after.pose.translation()).norm(), 1e-9);
  EXPECT_EQ(ask(arm.configuration_js).name.size(), 6u);
  EXPECT_EQ(ask(arm.spatial_jacobian).coefficients.size(), 36u);
  EXPECT_TRUE(ask(arm.measured_cs).position_is_valid);
}

TEST_P(Crtk, TheArmTellsWhatItRefuses) {
  ASSERT_TRUE(operator_.arm.state_command.start("resume").within(suture::kPatience));
  EXPECT_TRUE(heard([&] { return operator_.errors.size() == 1; }));
  const auto ratio = operator_.arm.trajectory_j_set_ratio.start(2).within(suture::kPatience);
  if (GetParam()) return;  // a process does not judge its own arguments
  ASSERT_FALSE(ratio);
  EXPECT_EQ(ratio.error(), suture::Errc::Invalid);
}

INSTANTIATE_TEST_SUITE_P(Processes, Crtk, testing::Bool(),
                         [](const auto& one) { return one.param ? "One" : "Two"; });

}  // namespace
}  // namespace robots::test
