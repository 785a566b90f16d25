#pragma once
// A simulated arm whose CRTK interface a test calls directly.

#include "arm/crtk_face.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "kinematics/pose_error.h"
#include "unit/arm/psm_model.h"
#include "unit/arm/trailing_joints.h"

namespace robots::test {

using namespace std::chrono_literals;

// Stands in for Provided<Arm>::emit() and Provided<CrtkArm>::emit().
struct HeardCrtk {
  std::vector<ArmState> desired, states;
  std::vector<bool> goals, gravity;
  std::vector<double> ratios;
  std::vector<std::string> statuses, warnings, errors;

  void desired_state(ArmState state) { desired.push_back(state); }
  void operating_state(const OperatingState& state) { states.push_back(state.state); }
  void goal_reached(bool reached) { goals.push_back(reached); }
  void gravity_compensation(bool on) { gravity.push_back(on); }
  void trajectory_j_ratio(double ratio) { ratios.push_back(ratio); }
  void trajectory_j_ratio_v(double) {}
  void trajectory_j_ratio_a(double) {}
  void status(const suture::Message& message) { statuses.push_back(message.text); }
  void warning(const suture::Message& message) { warnings.push_back(message.text); }
  void error(const suture::Message& message) { errors.push_back(message.text); }
};
struct Deaf {
  void operating_state(const OperatingState&) {}
  void goal_reached(bool) {}
  void warning(ArmWarning) {}
};

/// Obeys whom the test says.
struct CommandedArm final : ArmController<6> {
  using ArmController::ArmController;
  const suture::ConnectedClient* commander = nullptr;

 private:
  const suture::ConnectedClient* asking() const override { return commander; }
};

class CrtkFaceTest : public testing::Test {
 protected:
  CrtkFaceTest() {
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
      arm_.announce(Deaf{});
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
  void expectMoved(const PoseStamped& from, const Eigen::Vector3d& by) {
    const Eigen::Vector3d moved = crtk_.setpoint_cp().pose.translation() - from.pose.translation();
    EXPECT_LT((moved - by).norm(), 1e-6) << moved.transpose();
  }

  CommandedArm arm_{psmModel()};
  TrailingJoints<6> joints_{psmModel(), psmParked()};
  CrtkFace<6> crtk_{arm_};
  suture::Time time_ = suture::now();
  HeardCrtk heard_;
};

}  // namespace robots::test
