// The CRTK interface of a simulated arm, called directly: each command does what its name says.

#include "arm/crtk_face.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "arm/kinematics/pose_error.h"
#include "unit/arm/psm_model.h"

namespace robots::test {
namespace {

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

class CrtkFaceTest : public testing::Test {
 protected:
  CrtkFaceTest() {
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
      arm_.step(time_);
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

  SimulatedArm<6> arm_{psmModel()};
  CrtkFace<6> crtk_{arm_};
  suture::Time time_ = suture::now();
  HeardCrtk heard_;
};

TEST_F(CrtkFaceTest, ConfigurationSaysWhatTheJointsAre) {
  const JointConfiguration& configuration = crtk_.configuration_js();
  EXPECT_EQ(configuration.name.size(), 6u);
  EXPECT_EQ(configuration.type[1], JointType::Revolute);
  EXPECT_EQ(configuration.type[2], JointType::Prismatic);
  EXPECT_EQ(configuration.velocity_max[0], 4);
  EXPECT_LT(configuration.position_min[0], configuration.position_max[0]);
}

TEST_F(CrtkFaceTest, StateCommandsAreThoseOfTheStateMachine) {
  crtk_.state_command("pause");
  EXPECT_EQ(crtk_.operating_state().state, ArmState::Paused);
  crtk_.servo_jp(joints(0.2));
  cycles(1);
  EXPECT_NEAR(setpoint(0), 0.1, 1e-6) << "a paused arm does not move";
  crtk_.state_command("resume");
  EXPECT_EQ(crtk_.operating_state().state, ArmState::Enabled);
  crtk_.state_command("unhome");
  EXPECT_FALSE(crtk_.operating_state().is_homed);
  crtk_.state_command("disable");
  EXPECT_EQ(crtk_.operating_state().state, ArmState::Disabled);
  cycles(1);
  EXPECT_TRUE(heard_.errors.empty());
  crtk_.state_command("explode");
  cycles(1);
  crtk_.state_command("pause");
  cycles(1);
  EXPECT_EQ(heard_.errors.size(), 2u);
  EXPECT_EQ(heard_.desired.back(), ArmState::Disabled);
}

TEST_F(CrtkFaceTest, RelativeServoAddsUp) {
  crtk_.servo_jr(joints(0.01));
  crtk_.servo_jr(joints(0.01));
  cycles(1);
  EXPECT_NEAR(setpoint(0), 0.12, 1e-9);
  const PoseStamped before = crtk_.setpoint_cp();
  crtk_.servo_cr(step({0.001, 0, 0}));
  crtk_.servo_cr(step({0, 0.002, 0}));
  cycles(1);
  expectMoved(before, {0.001, 0.002, 0});
}

TEST_F(CrtkFaceTest, AVelocityMovesUntilItFallsSilent) {
  JointVelocityGoal goal;
  goal.goal.assign(6, 0.0);
  goal.goal[0] = 1.0;
  const double before = setpoint(0);
  for (int i = 0; i < 50; ++i) {
    crtk_.servo_jv(goal);
    cycles(1);
  }
  EXPECT_NEAR(setpoint(0) - before, 0.05, 0.002);
  EXPECT_EQ(crtk_.operating_state().sub_state, "servo_jv");
  cycles(90);
  EXPECT_EQ(crtk_.operating_state().sub_state, "servo_jv");
  cycles(20);
  EXPECT_EQ(crtk_.operating_state().sub_state, "holding");
}

TEST_F(CrtkFaceTest, AMaskedJointHolds) {
  JointVelocityGoal velocity;
  velocity.goal.assign(6, 0.5);
  velocity.mask = {true, false, true, true, true, true};
  JointEffortGoal effort;
  effort.effort.assign(6, 1.0);
  effort.mask = {false, true, true, true, true, true};
  const double first = setpoint(0), second = setpoint(1);
  for (int i = 0; i < 20; ++i) {
    crtk_.servo_jv(velocity);
    cycles(1);
  }
  EXPECT_NEAR(setpoint(0) - first, 0.01, 1e-9);
  EXPECT_EQ(setpoint(1), second);
  const double held = setpoint(0);
  for (int i = 0; i < 20; ++i) {
    crtk_.servo_jf(effort);
    cycles(1);
  }
  EXPECT_EQ(setpoint(0), held);
  EXPECT_NEAR(setpoint(1) - second, 0.01, 1e-9);
}

TEST_F(CrtkFaceTest, AJointStopsAtItsGuard) {
  JointVelocityGoal goal;
  goal.goal.assign(6, 0.0);
  for (const double direction : {1.0, -1.0}) {
    crtk_.hold();
    goal.goal[0] = direction;
    goal.guard = positions();
    goal.guard[0] += 0.0105 * direction;
    for (int i = 0; i < 30; ++i) {
      crtk_.servo_jv(goal);
      cycles(1);
    }
    EXPECT_EQ(setpoint(0), goal.guard[0]) << direction;
  }
}

TEST_F(CrtkFaceTest, AGuardThatLiesBehindStopsNobody) {
  JointVelocityGoal goal;
  goal.goal.assign(6, 0.0);
  goal.goal[0] = 1.0;
  goal.guard = positions();
  goal.guard[0] -= 0.01;
  const double before = setpoint(0);
  for (int i = 0; i < 20; ++i) {
    crtk_.servo_jv(goal);
    cycles(1);
  }
  EXPECT_NEAR(setpoint(0) - before, 0.02, 1e-9);
}

TEST_F(CrtkFaceTest, AVelocityIsReachedAndLeftWithTheAccelerationsAskedFor) {
  JointVelocityGoal goal;
  goal.goal.assign(6, 0.0);
  goal.goal[0] = 0.1;
  goal.acceleration.assign(6, 10.0);
  goal.deceleration.assign(6, 5.0);
  const auto travel = [&](int count) {
    const double before = setpoint(0);
    for (int i = 0; i < count; ++i) {
      crtk_.servo_jv(goal);
      cycles(1);
    }
    return setpoint(0) - before;
  };
  // 0.01 rad/s more each ms: 0.01 + ... + 0.1
  EXPECT_NEAR(travel(10), 0.55e-3, 1e-9);
  EXPECT_NEAR(travel(10), 1e-3, 1e-9);
  goal.goal[0] = -0.1;
  EXPECT_NEAR(travel(20), 0.95e-3, 1e-9) << "20 ms until it stands";
  EXPECT_NEAR(travel(10), -0.55e-3, 1e-9) << "and back";
}

TEST_F(CrtkFaceTest, ATwistIsReachedWithItsAccelerationAlongTheReferenceFrame) {
  PoseStamped base;
  base.pose.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  base.valid = true;
  crtk_.set_base_frame(base);
  cycles(1);
  TwistGoal goal;
  goal.linear = {0.02, 0.02, 0};
  goal.linear_acceleration = {1, 0, 0};
  const PoseStamped before = crtk_.setpoint_cp();
  for (int i = 0; i < 20; ++i) {
    crtk_.servo_cv(goal);
    cycles(1);
  }
  expectMoved(before, {0.21e-3, 0.4e-3, 0});
}

TEST_F(CrtkFaceTest, BoundsThatMakeNoSenseAreRefused) {
  JointVelocityGoal fine;
  fine.goal.assign(6, 0.1);
  const auto expectRefused = [&](const JointVelocityGoal& goal, const char* what) {
    crtk_.hold();
    cycles(1);
    const double before = setpoint(0);
    crtk_.servo_jv(goal);
    cycles(2);
    EXPECT_EQ(setpoint(0), before) << what;
    EXPECT_NE(crtk_.operating_state().sub_state, "servo_jv") << what;
  };
  JointVelocityGoal goal = fine;
  goal.mask.assign(5, true);
  expectRefused(goal, "a mask of five");
  goal = fine;
  goal.guard.assign(7, 0.0);
  expectRefused(goal, "a guard of seven");
  goal = fine;
  goal.acceleration.assign(6, 0.0);
  expectRefused(goal, "no acceleration");
  goal = fine;
  goal.deceleration.assign(6, std::nan(""));
  expectRefused(goal, "a deceleration that is no number");
  TwistGoal twist;
  twist.linear = {0.1, 0, 0};
  twist.linear_acceleration = {-1, 0, 0};
  crtk_.servo_cv(twist);
  cycles(1);
  EXPECT_NE(crtk_.operating_state().sub_state, "servo_cv");
}

TEST_F(CrtkFaceTest, HoldEndsAStream) {
  JointVelocityGoal goal;
  goal.goal.assign(6, 1.0);
  crtk_.servo_jv(goal);
  cycles(2);
  crtk_.hold();
  cycles(1);
  const double held = setpoint(0);
  cycles(10);
  EXPECT_EQ(setpoint(0), held);
}

TEST_F(CrtkFaceTest, ATwistMovesTheTipInTheReferenceFrame) {
  TwistGoal goal;
  goal.linear = {0.02, 0, 0};
  const PoseStamped before = crtk_.setpoint_cp();
  for (int i = 0; i < 50; ++i) {
    crtk_.servo_cv(goal);
    cycles(1);
  }
  expectMoved(before, {0.001, 0, 0});
  EXPECT_NEAR(crtk_.setpoint_cv().linear.x(), 0.02, 1e-12);
  EXPECT_NEAR(crtk_.measured_cv().linear.x(), 0.02, 0.002);
}

TEST_F(CrtkFaceTest, AForcePushesAndIsMeasured) {
  WrenchGoal goal;
  goal.force = {1, 0, 0};
  const PoseStamped before = crtk_.setpoint_cp();
  for (int i = 0; i < 50; ++i) {
    crtk_.spatial_servo_cf(goal);
    cycles(1);
  }
  expectMoved(before, {0.001, 0, 0});
  EXPECT_NEAR(crtk_.spatial_measured_cf().force.x(), 1, 1e-9);
  const Eigen::Matrix3d tip = crtk_.local_measured_cp().pose.linear();
  EXPECT_LT((tip * crtk_.body_measured_cf().force - goal.force).norm(), 1e-9);
  crtk_.hold();
  cycles(1);
  EXPECT_EQ(crtk_.spatial_measured_cf().force.norm(), 0);
}

TEST_F(CrtkFaceTest, ABodyForcePushesAlongTheTip) {
  WrenchGoal goal;
  goal.force = {0, 0, 1};
  const PoseStamped before = crtk_.setpoint_cp();
  for (int i = 0; i < 50; ++i) {
    crtk_.body_servo_cf(goal);
    cycles(1);
  }
  expectMoved(before, 0.001 * before.pose.linear().col(2));
}

TEST_F(CrtkFaceTest, AnEffortMovesItsJoint) {
  JointEffortGoal goal;
  goal.effort.assign(6, 0.0);
  goal.effort[1] = 2.0;
  const double before = setpoint(1);
  for (int i = 0; i < 50; ++i) {
    crtk_.servo_jf(goal);
    cycles(1);
  }
  EXPECT_NEAR(setpoint(1) - before, 0.05, 0.002);
}

TEST_F(CrtkFaceTest, MovesEndAtTheirGoals) {
  crtk_.move_jr(joints(0.02));
  cycles(1);
  EXPECT_NEAR(crtk_.goal_js().position[0], 0.12, 1e-9);
  while (heard_.goals.empty()) cycles(1);
  EXPECT_TRUE(heard_.goals.back());
  EXPECT_NEAR(setpoint(0), 0.12, 1e-9);

  const PoseStamped before = crtk_.setpoint_cp();
  PoseStamped goal = before;
  goal.pose.translation().x() += 0.003;
  crtk_.move_cp(goal);
  while (heard_.goals.size() < 2) cycles(1);
  expectMoved(before, {0.003, 0, 0});
  crtk_.move_cr(step({0, 0.002, 0}));
  while (heard_.goals.size() < 3) cycles(1);
  expectMoved(before, {0.003, 0.002, 0});
}

TEST_F(CrtkFaceTest, ARatioSlowsMoves) {
  const auto cyclesFor = [&](double ratio) {
    crtk_.trajectory_j_set_ratio_v(ratio);
    heard_ = {};
    crtk_.move_jr(joints(ratio == 1 ? 0.1 : -0.1));
    int count = 0;
    while (heard_.goals.empty()) cycles(1), ++count;
    return count;
  };
  const int fast = cyclesFor(1), slow = cyclesFor(0.5);
  EXPECT_NEAR(slow, 2 * fast, 2);
  EXPECT_EQ(crtk_.trajectory_j_ratio(), 0.5);
  EXPECT_EQ(crtk_.trajectory_j_ratio_a(), 1);
}

TEST_F(CrtkFaceTest, FreeFollowsTheJoints) {
  crtk_.servo_jp(joints(0.3));
  cycles(1);
  crtk_.free();
  cycles(200);
  EXPECT_LT(setpoint(0), 0.29) << "nothing drives it to the goal any more";
  EXPECT_EQ(crtk_.operating_state().sub_state, "free");
}

TEST_F(CrtkFaceTest, TheBaseFrameTurnsPosesAndGoals) {
  const PoseStamped local = crtk_.local_setpoint_cp();
  PoseStamped frame = step({1, 2, 3});
  frame.pose.linear() = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  crtk_.set_base_frame(frame);
  EXPECT_LT(kinematics::poseError(crtk_.setpoint_cp().pose, frame.pose * local.pose).norm(), 1e-12);
  PoseStamped goal = crtk_.setpoint_cp();
  crtk_.servo_cp(goal);
  cycles(1);
  EXPECT_LT(kinematics::poseError(crtk_.local_setpoint_cp().pose, local.pose).norm(), 1e-6);
  EXPECT_LT(kinematics::poseError(crtk_.base_frame().pose, frame.pose).norm(), 1e-12);
}

TEST_F(CrtkFaceTest, QuestionsAreAnsweredInTheReferenceFrame) {
  crtk_.set_base_frame(step({1, 0, 0}));
  const JointGoal all = joints(0.1);
  const PoseStamped tip = crtk_.forward_kinematics(all);
  EXPECT_LT(kinematics::poseError(crtk_.query_cp(all).pose, tip.pose).norm(), 1e-12);
  EXPECT_TRUE(crtk_.inverse_kinematics(tip).found);
  EXPECT_EQ(crtk_.local_query_cp({}).pose.translation().norm(), 0);
  EXPECT_FALSE(crtk_.query_cp({std::vector<double>(7, 0.0), {}}).valid);
}

TEST_F(CrtkFaceTest, JacobiansTurnJointsIntoTips) {
  JointVelocityGoal goal;
  goal.goal.assign(6, 0.1);
  for (int i = 0; i < 60; ++i) {
    crtk_.servo_jv(goal);
    cycles(1);
  }
  const Jacobian& jacobian = crtk_.spatial_jacobian();
  EXPECT_EQ(jacobian.joints, 6u);
  const Eigen::Map<const Eigen::Matrix<double, 6, 6>> matrix(jacobian.coefficients.data());
  const Eigen::Map<const Eigen::Matrix<double, 6, 1>> rates(crtk_.measured_js().velocity.data());
  EXPECT_LT(((matrix * rates).head<3>() - crtk_.measured_cv().linear).norm(), 1e-12);
}

TEST_F(CrtkFaceTest, GravityCompensationIsTold) {
  crtk_.use_gravity_compensation(true);
  cycles(1);
  EXPECT_EQ(heard_.gravity, std::vector<bool>{true});
}

TEST_F(CrtkFaceTest, RefusalsAreWarnings) {
  crtk_.servo_cr(PoseStamped{});  // not valid
  cycles(1);
  crtk_.disable();
  crtk_.free();
  cycles(1);
  ASSERT_EQ(heard_.warnings.size(), 2u);
  EXPECT_NE(heard_.warnings[1].find("enabled"), std::string::npos);
}

TEST(PeriodStatistics, AreOfTheLastWholeSecond) {
  PeriodStatistics statistics;
  suture::Time time = suture::now();
  EXPECT_FALSE(statistics.last().valid);
  for (int i = 0; i <= 1000; ++i) statistics.cycle(time += 1ms);
  EXPECT_TRUE(statistics.last().valid);
  EXPECT_NEAR(statistics.last().period_average, 0.001, 1e-9);
  EXPECT_NEAR(statistics.last().period_max, 0.001, 1e-9);
  EXPECT_NEAR(statistics.last().period_deviation, 0, 1e-6);
}

}  // namespace
}  // namespace robots::test
