// These call the contract of a simulated arm directly: each command does what its name says.
#include <gtest/gtest.h>

#include "unit/arm/crtk_arm_fixture.h"

namespace robots::test {
namespace {

TEST_F(CrtkArmTest, ConfigurationSaysWhatTheJointsAre) {
  const JointConfiguration& configuration = crtk_.configuration_js();
  EXPECT_EQ(configuration.name.size(), 6u);
  EXPECT_EQ(configuration.type[1], JointType::Revolute);
  EXPECT_EQ(configuration.type[2], JointType::Prismatic);
  EXPECT_EQ(configuration.velocity_max[0], 4);
  EXPECT_LT(configuration.position_min[0], configuration.position_max[0]);
}

TEST_F(CrtkArmTest, StateCommandsFollowTheStateMachine) {
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

TEST_F(CrtkArmTest, RelativeServoAddsUp) {
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

TEST_F(CrtkArmTest, MovesEndAtTheirGoals) {
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

TEST_F(CrtkArmTest, ARatioSlowsMoves) {
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

TEST_F(CrtkArmTest, FreeFollowsTheJoints) {
  crtk_.servo_jp(joints(0.3));
  cycles(1);
  crtk_.free();
  cycles(200);
  EXPECT_LT(setpoint(0), 0.29) << "nothing drives it to the goal any more";
  EXPECT_EQ(crtk_.operating_state().sub_state, "free");
}

TEST_F(CrtkArmTest, TheBaseFrameTurnsPosesAndGoals) {
  const PoseStamped local = crtk_.local_setpoint_cp();
  TransformStamped base = baseAt({1, 2, 3});
  base.transform.linear() = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  crtk_.set_base_frame(base);
  const Eigen::Isometry3d turned = base.transform * local.pose;
  EXPECT_LT(kinematics::poseError(crtk_.setpoint_cp().pose, turned).norm(), 1e-12);
  PoseStamped goal = crtk_.setpoint_cp();
  crtk_.servo_cp(goal);
  cycles(1);
  EXPECT_LT(kinematics::poseError(crtk_.local_setpoint_cp().pose, local.pose).norm(), 1e-6);
  EXPECT_LT(kinematics::poseError(crtk_.base_frame().transform, base.transform).norm(), 1e-12);
}

TEST_F(CrtkArmTest, ABaseInAnotherFrameIsRefused) {
  crtk_.nameFrames({.reference = "scene", .moving = "tip"});
  const PoseStamped before = crtk_.setpoint_cp();
  TransformStamped base = baseAt({1, 0, 0});
  for (const suture::FrameId other : {suture::FrameId{0}, suture::frameId("camera")}) {
    base.reference_frame = other;
    crtk_.set_base_frame(base);
  }
  cycles(1);
  EXPECT_EQ(heard_.codes, std::vector{ArmWarning::WrongFrame});
  expectMoved(before, {0, 0, 0});
  base.reference_frame = suture::frameId("scene");
  base.moving_frame = suture::frameId("PSM1_base");
  crtk_.set_base_frame(base);
  expectMoved(before, {1, 0, 0});
}

TEST_F(CrtkArmTest, AnUndeclaredFrameTakesAnyBase) {
  const PoseStamped before = crtk_.setpoint_cp();
  TransformStamped base = baseAt({1, 0, 0});
  base.reference_frame = suture::frameId("scene");
  crtk_.set_base_frame(base);
  expectMoved(before, {1, 0, 0});
}

TEST_F(CrtkArmTest, AMovingArmKeepsItsBase) {
  crtk_.servo_cp(crtk_.setpoint_cp());
  cycles(1);
  const PoseStamped before = crtk_.setpoint_cp();
  crtk_.set_base_frame(baseAt({0.03, 0, 0}));
  cycles(1);
  expectMoved(before, {0, 0, 0});
  EXPECT_EQ(heard_.codes, std::vector{ArmWarning::InMotion});
}

/// The goals of a stream that still come were made in the previous frame.
TEST_F(CrtkArmTest, AStreamOfTipsKeepsItsBase) {
  const std::vector<std::pair<const char*, std::function<void()>>> rests{
      {"hold", [this] { crtk_.hold(); }}, {"pause", [this] { crtk_.pause(); }}, {"disable", [this] {
                                                                                   crtk_.disable();
                                                                                 }}};
  const PoseStamped there = crtk_.setpoint_cp(), here = step(Eigen::Vector3d::Zero());
  const std::vector<std::pair<const char*, std::function<void()>>> streams{
      {"servo_cp", [&] { crtk_.servo_cp(there); }},
      {"servo_cr", [&] { crtk_.servo_cr(here); }},
      {"servo_cv", [&] { crtk_.servo_cv({}); }},
      {"interpolate_cp", [&] { crtk_.interpolate_cp(there); }},
      {"interpolate_cr", [&] { crtk_.interpolate_cr(here); }}};
  for (const auto& [rest, toRest] : rests) {
    for (const auto& [stream, goal] : streams) {
      SCOPED_TRACE(std::string(stream) + ", then " + rest);
      goal();
      cycles(5);
      toRest();
      goal();  // obeyed or refused, it is of a stream
      toRest();
      cycles(99);
      crtk_.set_base_frame(baseAt({0.02, 0, 0}));
      expectMoved(there, {0, 0, 0});
      cycles(3);
      crtk_.set_base_frame(baseAt({0.02, 0, 0}));
      expectMoved(there, {0.02, 0, 0});
      crtk_.set_base_frame(baseAt({0, 0, 0}));
      crtk_.resume();
      crtk_.enable();
      cycles(1);
    }
  }
}

TEST_F(CrtkArmTest, MotionAndForceNameTheirFrames) {
  crtk_.nameFrames({.reference = "scene", .moving = "tip"});
  const suture::FrameId scene = suture::frameId("scene"), tip = suture::frameId("tip");
  const auto expectFrames = [&](const auto& data, suture::FrameId reference) {
    EXPECT_EQ(data.moving_frame, tip);
    EXPECT_EQ(data.reference_frame, reference);
  };
  cycles(1);
  expectFrames(crtk_.measured_cv(), scene);
  expectFrames(crtk_.setpoint_cv(), scene);
  expectFrames(crtk_.measured_cs(), scene);
  expectFrames(crtk_.body_measured_cf(), tip);
  expectFrames(crtk_.spatial_measured_cf(), scene);
  TransformStamped base = baseAt({1, 0, 0});
  base.reference_frame = scene;
  base.moving_frame = suture::frameId("base");
  crtk_.set_base_frame(base);
  cycles(1);
  expectFrames(crtk_.spatial_measured_cf(), base.moving_frame);
}

TEST_F(CrtkArmTest, QuestionsAreAnsweredInTheReferenceFrame) {
  crtk_.set_base_frame(baseAt({1, 0, 0}));
  const JointGoal all = joints(0.1);
  const PoseStamped tip = crtk_.forward_kinematics(all);
  EXPECT_LT(kinematics::poseError(crtk_.query_cp(all).pose, tip.pose).norm(), 1e-12);
  EXPECT_TRUE(crtk_.inverse_kinematics(tip).found);
  EXPECT_EQ(crtk_.local_query_cp({}).pose.translation().norm(), 0);
  EXPECT_FALSE(crtk_.query_cp({std::vector<double>(7, 0.0), {}}).valid);
}

TEST_F(CrtkArmTest, JacobiansTurnJointsIntoTips) {
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

TEST_F(CrtkArmTest, GravityCompensationIsToldInEveryState) {
  EXPECT_TRUE(crtk_.motorOrder().compensation) << "at first";
  crtk_.use_gravity_compensation(false);
  cycles(1);
  EXPECT_EQ(heard_.gravity, std::vector<bool>{false});
  EXPECT_FALSE(crtk_.motorOrder().compensation);
  crtk_.pause();
  cycles(1);
  EXPECT_FALSE(crtk_.motorOrder().compensation);
  crtk_.use_gravity_compensation(true);
  crtk_.disable();
  cycles(1);
  EXPECT_TRUE(crtk_.motorOrder().compensation);
  EXPECT_EQ(heard_.gravity, (std::vector<bool>{false, true}));
}

TEST_F(CrtkArmTest, RefusalsAreWarnings) {
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

TEST_F(CrtkArmTest, ARoundedBaseIsMadeExact) {
  TransformStamped base = baseAt({0.1, 0, 0});
  base.transform.linear().topLeftCorner<2, 2>() << 0.707107, -0.707107, 0.707107, 0.707107;
  crtk_.set_base_frame(base);
  cycles(1);
  crtk_.servo_cp(crtk_.setpoint_cp());
  cycles(1);
  EXPECT_TRUE(heard_.codes.empty());
  EXPECT_EQ(crtk_.operating_state().sub_state, "servo_cp");
}

TEST_F(CrtkArmTest, APausedMoveBeginsAtTheJoints) {
  crtk_.unhome();
  cycles(1);
  heard_ = {};
  std::vector<double> goal = positions();
  goal[0] += 0.1;
  time_ += 150ms;  // longer than the drives go on with a goal
  crtk_.move_jp({goal, {}});
  cycles(1);
  EXPECT_EQ(crtk_.operating_state().sub_state, "moving");
  EXPECT_TRUE(heard_.goals.empty()) << "nothing has replaced it";
  cycles(2000);
  EXPECT_EQ(heard_.goals, std::vector{true});
  EXPECT_NEAR(setpoint(0), goal[0], 1e-9);

  time_ += 150ms;
  crtk_.home();
  cycles(2000);
  EXPECT_TRUE(crtk_.operating_state().is_homed);
}

TEST_F(CrtkArmTest, APauseEndsAnEarlierMove) {
  std::vector<double> goal = positions();
  goal[0] += 0.5;
  crtk_.move_jp({goal, {}});
  cycles(10);
  time_ += 150ms;
  cycles(1);
  EXPECT_EQ(crtk_.operating_state().sub_state, "holding");
  EXPECT_EQ(heard_.goals, std::vector{false});
}

}  // namespace
}  // namespace robots::test
