#include "rt/task_thread/arm_user.h"

#include <chrono>
#include <iterator>
#include <string>

#include "kinematics/davinci.h"
#include "rt/task_thread/arm_tasks.h"

namespace proof {

using suture::Result;

constexpr double kHome = 0.15;  // rad, of each joint

robots::ArmModel<7> masterArm() {
  using Joints = robots::ArmModel<7>::Joints;
  return {.chain = robots::kinematics::mtmLeft(),
          .joint_names = {"outer_yaw", "shoulder_pitch", "elbow_pitch", "platform", "wrist_pitch",
                          "wrist_yaw", "roll"},
          .home = Joints::Constant(kHome),
          .rate_limit = Joints::Constant(4)};
}

ArmUser::ArmUser(suture::Required<robots::Arm>& arm) : arm_(arm) {
  here_.position.assign(7, kHome);
  step_.position.assign(7, 0.001);
  short_.position.assign(3, 0.0);
  velocity_.goal.assign(7, 0.1);
  effort_.effort.assign(7, 0.1);
  noStep_.valid = true;
  base_.valid = true;
  arm_.configuration_js.reserve(configuration_);
  arm_.operating_state.reserve(state_);
  arm_.measured_js.reserve(joints_);
  arm_.measured_cs.reserve(cartesian_);
  arm_.body_jacobian.reserve(jacobian_);
  subscribe();
  for (const auto& steps : {stateSteps(), streamSteps(), moveSteps(), settingSteps()}) {
    steps_.insert(steps_.end(), steps.begin(), steps.end());
  }
}

bool ArmUser::isWarm() const {
  return commands > 50 * steps_.size() && answers > 1000 &&
         suture::now() - began_ > std::chrono::milliseconds(1200);
}

void ArmUser::cycle() {
  if (began_ == suture::Time{}) began_ = suture::now();
  readAll();
  readMotion();
  refused += steps_[next_]() ? 0 : 1;
  next_ = (next_ + 1) % steps_.size();
  ++commands;
  ask();
}

void ArmUser::subscribe() {
  auto& on = arm_.on();
  on.operating_state([this](const robots::OperatingState&) { ++events; });
  on.desired_state([this](robots::ArmState) { ++events; });
  on.goal_reached([this](bool) { ++events; });
  on.gravity_compensation([this](bool) { ++events; });
  on.trajectory_j_ratio([this](double) { ++events; });
  on.trajectory_j_ratio_v([this](double) { ++events; });
  on.trajectory_j_ratio_a([this](double) { ++events; });
  on.status([this](const suture::Message&) { ++events; });
  on.warning([this](const suture::Message&) { ++events; });
  on.error([this](const suture::Message&) { ++events; });
}

// The steps end with an arm that is enabled and homed, since what follows moves it. An arm that
// rests where it is at home is homed in the cycle in which it is asked. One word names no command,
// for `error`.
std::vector<ArmUser::Step> ArmUser::stateSteps() {
  static const std::string enable = "enable", nonsense = "no such command";
  return {
      [this] { return arm_.disable(); },
      [this] { return arm_.servo_jp(here_); },  // refused by the arm, for `warning`
      [this] { return arm_.unhome(); },
      [this] { return arm_.state_command(nonsense); },
      [this] { return arm_.state_command(enable); },
      [this] { return arm_.pause(); },
      [this] { return arm_.resume(); },
      [this] { return arm_.disable(); },
      [this] { return arm_.enable(); },
      [this] { return arm_.servo_jp(here_); },
      [this] { return arm_.hold(); },
      [this] { return arm_.home(); },
  };
}

std::vector<ArmUser::Step> ArmUser::streamSteps() {
  return {
      [this] { return arm_.servo_jp(here_); },
      [this] { return arm_.servo_jr(step_); },
      [this] { return arm_.servo_jv(velocity_); },
      [this] { return arm_.servo_jf(effort_); },
      [this] { return arm_.servo_cp(pose_); },
      [this] { return arm_.servo_cr(noStep_); },
      [this] { return arm_.servo_cv({}); },
      [this] { return arm_.body_servo_cf({}); },
      [this] { return arm_.spatial_servo_cf({}); },
      [this] { return arm_.servo_jp(short_); },
      [this] { return arm_.free(); },
      [this] { return arm_.hold(); },
  };
}

std::vector<ArmUser::Step> ArmUser::moveSteps() {
  return {
      [this] { return arm_.interpolate_jp(here_); },
      [this] { return arm_.interpolate_jr(step_); },
      [this] { return arm_.interpolate_cp(pose_); },
      [this] { return arm_.interpolate_cr(noStep_); },
      [this] { return arm_.move_jp(here_); },
      [this] { return arm_.move_jr(step_); },
      [this] { return arm_.move_cp(pose_); },
      [this] { return arm_.move_cr(noStep_); },
  };
}

std::vector<ArmUser::Step> ArmUser::settingSteps() {
  return {
      [this] { return arm_.set_base_frame(base_); },
      [this] { return arm_.use_gravity_compensation(true); },
      [this] { return arm_.trajectory_j_set_ratio(0.5); },
      [this] { return arm_.trajectory_j_set_ratio_v(0.6); },
      [this] { return arm_.trajectory_j_set_ratio_a(0.7); },
  };
}

void ArmUser::readAll() {
  read(arm_.configuration_js, configuration_);
  read(arm_.operating_state, state_);
  read(arm_.period_statistics, periods_);
  read(arm_.trajectory_j_ratio, ratio_);
  read(arm_.trajectory_j_ratio_v, ratio_);
  read(arm_.trajectory_j_ratio_a, ratio_);
  read(arm_.base_frame, base_);
  read(arm_.body_measured_cf, wrench_);
  read(arm_.spatial_measured_cf, wrench_);
  read(arm_.body_jacobian, jacobian_);
  read(arm_.spatial_jacobian, jacobian_);
}

// Ends with the set-point: where the arm can be sent.
void ArmUser::readMotion() {
  read(arm_.measured_js, joints_);
  read(arm_.setpoint_js, joints_);
  read(arm_.goal_js, joints_);
  read(arm_.measured_cv, twist_);
  read(arm_.setpoint_cv, twist_);
  read(arm_.measured_cs, cartesian_);
  read(arm_.measured_cp, pose_);
  read(arm_.goal_cp, pose_);
  read(arm_.local_measured_cp, pose_);
  read(arm_.local_setpoint_cp, pose_);
  read(arm_.setpoint_cp, pose_);
}

void ArmUser::ask() {
  if (question_ && question_->poll()) {
    answers += *question_->poll() ? 1 : 0;
    question_.reset();
  }
  if (!question_) question_.emplace(arm_.forward_kinematics.start(here_));
  if (problem_ && problem_->poll()) {
    answers += *problem_->poll() ? 1 : 0;
    problem_.reset();
  }
  if (!problem_ && next_ == 0) problem_.emplace(arm_.inverse_kinematics.start(pose_));
}

}  // namespace proof
