// These send goals of numbers that no arm can mean, whose products are not finite.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "unit/arm/crtk_arm_fixture.h"

namespace robots::test {
namespace {

constexpr double kHuge = 1e308;

class GoalRangeTest : public CrtkArmTest {
 protected:
  GoalRangeTest() {
    joints_.controlEfforts();
    cycles(1);
    twist_.linear.setConstant(kHuge);
    wrench_.force.setConstant(kHuge);
    velocity_.goal.assign(6, kHuge);
    effort_.effort.assign(6, kHuge);
  }

  std::vector<Command> hugeGoals() {
    const PoseStamped pose = step(Eigen::Vector3d::Constant(kHuge));
    return {{"servo_jp", [this] { crtk_.servo_jp(joints(kHuge)); }},
            {"servo_jr", [this] { crtk_.servo_jr(joints(kHuge)); }},
            {"servo_jv", [this] { crtk_.servo_jv(velocity_); }},
            {"servo_jf", [this] { crtk_.servo_jf(effort_); }},
            {"servo_cp", [this, pose] { crtk_.servo_cp(pose); }},
            {"servo_cr", [this, pose] { crtk_.servo_cr(pose); }},
            {"servo_cv", [this] { crtk_.servo_cv(twist_); }},
            {"body_servo_cf", [this] { crtk_.body_servo_cf(wrench_); }},
            {"spatial_servo_cf", [this] { crtk_.spatial_servo_cf(wrench_); }},
            {"interpolate_jp", [this] { crtk_.interpolate_jp(joints(kHuge)); }},
            {"interpolate_cp", [this, pose] { crtk_.interpolate_cp(pose); }},
            {"move_jp", [this] { crtk_.move_jp(joints(kHuge)); }},
            {"move_cp", [this, pose] { crtk_.move_cp(pose); }}};
  }

  TwistGoal twist_;
  WrenchGoal wrench_;
  JointVelocityGoal velocity_;
  JointEffortGoal effort_;
};

TEST_F(GoalRangeTest, IsRefusedWithoutAnyMotion) {
  const std::vector<double> before = positions();
  for (const auto& [name, command] : hugeGoals()) {
    heard_ = {};
    command();
    cycles(2);
    EXPECT_EQ(heard_.codes, std::vector{ArmWarning::Malformed}) << name;
    EXPECT_EQ(positions(), before) << name;
    EXPECT_EQ(crtk_.motorOrder().effort.norm(), 0) << name << ": what the motors give";
    crtk_.servo_jp({before, {}});  // obeyed, so the next refusal is news
    cycles(1);
  }
}

TEST_F(GoalRangeTest, IsRefusedAsABaseToo) {
  crtk_.hold();
  cycles(1);
  crtk_.set_base_frame(baseAt(Eigen::Vector3d::Constant(kHuge)));
  cycles(1);
  EXPECT_EQ(heard_.codes, std::vector{ArmWarning::Malformed});
  EXPECT_TRUE(crtk_.measured_cp().pose.matrix().allFinite());
}

TEST_F(GoalRangeTest, HasNoAnswer) {
  EXPECT_FALSE(crtk_.forward_kinematics(joints(kHuge)).valid);
  EXPECT_FALSE(crtk_.query_cp(joints(kHuge)).valid);
  EXPECT_FALSE(crtk_.inverse_kinematics(step(Eigen::Vector3d::Constant(kHuge))).found);
}

}  // namespace
}  // namespace robots::test
