#pragma once
// This is a simulated arm whose contract a test calls directly.

#include "arm_control/crtk_arm.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/pose_error.h"
#include "unit/arm/deaf.h"
#include "unit/arm/psm_model.h"
#include "unit/arm/trailing_joints.h"

namespace robots::test {

using namespace std::chrono_literals;

struct HeardOfArm : Deaf {
  std::vector<ArmState> desired, states;
  std::vector<bool> goals, gravity;
  std::vector<double> ratios;
  std::vector<std::string> statuses, warnings, errors;
  std::vector<ArmWarning> codes;  // each warning and each error has one

  void desired_state(ArmState state) { desired.push_back(state); }
  void operating_state(const OperatingState& state) { states.push_back(state.state); }
  void goal_reached(bool reached) { goals.push_back(reached); }
  void gravity_compensation(bool on) { gravity.push_back(on); }
  void trajectory_j_ratio(double ratio) { ratios.push_back(ratio); }
  void status(const suture::Message& message) { statuses.push_back(message.text); }
  void warning(const suture::Message& message) { hear(message, warnings); }
  void error(const suture::Message& message) { hear(message, errors); }

 private:
  void hear(const suture::Message& message, std::vector<std::string>& texts) {
    texts.push_back(message.text);
    codes.push_back(static_cast<ArmWarning>(message.code));
  }
};

/// Takes each command as one of the client that the test sets.
struct CommandedArm final : ArmController<6> {
  using ArmController::ArmController;
  const suture::ConnectedClient* commander = nullptr;

 private:
  const suture::ConnectedClient* asking() const override { return commander; }
};

class CrtkArmTest : public testing::Test {
 protected:
  explicit CrtkArmTest(const ArmModel<6>& model = psmModel())
      : arm_(model), joints_(model, psmParked()) {
    cycles(1);
    crtk_.enable();
    crtk_.home();
    while (!crtk_.operating_state().is_homed) cycles(1);
    cycles(200);
    heard_ = {};
  }

  void cycles(int count) {
    for (int i = 0; i < count; ++i) {
      time_ += 1ms;
      crtk_.advance(time_);
      joints_.step(arm_, time_);
      crtk_.publish(time_);
      crtk_.announce(heard_);
    }
  }
  double setpoint(std::size_t joint) const { return crtk_.setpoint_js().position[joint]; }
  std::vector<double> positions() const {
    const auto& all = crtk_.setpoint_js().position;
    return {all.begin(), all.end()};
  }
  static JointGoal joints(double value) { return {std::vector<double>(6, value), {}}; }
  static PoseStamped step(const Eigen::Vector3d& translation) {
    PoseStamped pose;
    pose.pose.translation() = translation;
    pose.valid = true;
    return pose;
  }
  static TransformStamped baseAt(const Eigen::Vector3d& translation) {
    TransformStamped base;
    base.transform.translation() = translation;
    base.valid = true;
    return base;
  }
  /// Expects the arm to refuse each Cartesian command and to say so once, but to obey joint goals.
  void expectTipRefused(ArmWarning reason) {
    const std::vector<double> before = positions();
    for (const auto& [name, command] : tipCommands()) {
      heard_ = {};
      for (int i = 0; i < 5; ++i) {
        command();
        cycles(1);
      }
      EXPECT_EQ(heard_.codes, std::vector{reason}) << name << ": once";
      EXPECT_EQ(positions(), before) << name;
      crtk_.servo_jp({before, {}});  // obeyed, so the next refusal is news
      cycles(1);
      EXPECT_EQ(crtk_.operating_state().sub_state, "servo_jp");
      crtk_.hold();
    }
  }
  void expectMoved(const PoseStamped& from, const Eigen::Vector3d& by) {
    const Eigen::Vector3d moved = crtk_.setpoint_cp().pose.translation() - from.pose.translation();
    EXPECT_LT((moved - by).norm(), 1e-6) << moved.transpose();
  }

  using Command = std::pair<const char*, std::function<void()>>;
  /// Returns all Cartesian commands. Each would move the tip a little, or keep it where it is asked
  /// to be already.
  std::vector<Command> tipCommands() {
    const PoseStamped there = crtk_.setpoint_cp(), small = step({0, 0, 1e-4});
    TwistGoal twist;
    twist.linear.z() = 0.01;
    WrenchGoal wrench;
    wrench.force.z() = 1;
    return {{"servo_cp", [this, there] { crtk_.servo_cp(there); }},
            {"servo_cr", [this, small] { crtk_.servo_cr(small); }},
            {"servo_cv", [this, twist] { crtk_.servo_cv(twist); }},
            {"body_servo_cf", [this, wrench] { crtk_.body_servo_cf(wrench); }},
            {"spatial_servo_cf", [this, wrench] { crtk_.spatial_servo_cf(wrench); }},
            {"interpolate_cp", [this, there] { crtk_.interpolate_cp(there); }},
            {"interpolate_cr", [this, small] { crtk_.interpolate_cr(small); }},
            {"move_cp", [this, there] { crtk_.move_cp(there); }},
            {"move_cr", [this, small] { crtk_.move_cr(small); }}};
  }

  CommandedArm arm_;
  TrailingJoints<6> joints_;
  CrtkArm<6> crtk_{arm_};
  suture::Time time_ = suture::now();
  HeardOfArm heard_;
};

}  // namespace robots::test
