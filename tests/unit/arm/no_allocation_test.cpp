// An arm's cycle never touches the heap once it is constructed: counted in front of the C library.

#include <gtest/gtest.h>

#include <chrono>

#include "arm_control/crtk_arm.h"
#include "arm_control/gripper_reading.h"
#include "arm_control/jaw_controller.h"
#include "kinematics/davinci.h"
#include "kinematics/mtm_inverse.h"
#include "support/allocations.h"
#include "unit/arm/deaf.h"
#include "unit/arm/psm_model.h"
#include "unit/arm/trailing_joints.h"

namespace robots::test {
namespace {

using suture::allocations;
using MtmJoints = ArmModel<7>::Joints;

ArmModel<7> mtmModel() {
  return {.chain = kinematics::mtmLeft(),
          .joint_names = {"a", "b", "c", "d", "e", "f", "g"},
          .home = MtmJoints::Constant(0.2),
          .rate_limit = MtmJoints::Constant(4),
          .inverse = kinematics::mtmInverse};
}

TEST(ArmController, NeverAllocatesInItsCycle) {
  ArmController<7> arm(mtmModel());
  TrailingJoints<7> joints(mtmModel(), MtmJoints::Constant(0.1));
  const JointGoal elsewhere{std::vector<double>(7, 0.15), {}};
  suture::Time time = suture::fromNanoseconds(1);
  const std::uint64_t before = allocations();

  joints.step(arm, time);
  arm.obey(StateCommand::Enable);
  arm.obey(StateCommand::Home);
  for (int i = 0; i < 1000; ++i) {
    time += std::chrono::milliseconds(1);
    if (i == 300) arm.move_jp(elsewhere);
    if (i > 600) {
      PoseStamped goal = arm.motion().setpoint_cp();
      goal.pose.translation().x() += i % 100 == 0 ? 1.0 : 0.0001;  // out of reach now and then
      arm.servo_cp(goal);
    }
    joints.step(arm, time);
  }
  EXPECT_EQ(allocations() - before, 0u);
}

TEST(CrtkArm, NeverAllocatesInItsCycle) {
  ArmController<7> arm(mtmModel());
  TrailingJoints<7> joints(mtmModel(), MtmJoints::Constant(0.1));
  CrtkArm<7> crtk(arm);
  const JointGoal step{std::vector<double>(7, 0.001), {}};
  JointVelocityGoal velocity;
  velocity.goal.assign(7, 0.1);
  const TwistGoal twist;
  const WrenchGoal wrench;
  JointEffortGoal efforts;
  efforts.effort.assign(7, 0.1);
  efforts.mask.assign(7, true);
  const std::string unknown = "no such command";
  Eigen::Index ordered = 0;
  suture::Time time = suture::fromNanoseconds(1);
  const std::uint64_t before = allocations();

  joints.step(arm, time);
  crtk.enable();
  crtk.home();
  for (int i = 0; i < 1400; ++i) {
    time += std::chrono::milliseconds(1);
    if (i == 1099) joints.controlEfforts();  // which the arm hears in this cycle
    switch (i / 100) {
      case 0: break;  // it homes, for only then it obeys Cartesian commands
      case 1: crtk.move_jr(step); break;
      case 2: crtk.servo_jr(step); break;
      case 3: crtk.servo_jv(velocity); break;
      case 4: crtk.servo_cv(twist); break;
      case 5: crtk.body_servo_cf(wrench); break;
      case 6: crtk.move_cp(crtk.setpoint_cp()); break;
      case 7: crtk.state_command(unknown); break;
      case 8: crtk.interpolate_jr(step); break;
      case 9: crtk.interpolate_cp(crtk.measured_cp()); break;
      case 11: crtk.servo_jf(efforts); break;
      case 12: crtk.body_servo_cf(wrench); break;
      default: crtk.free();
    }
    crtk.advance(time);
    joints.step(arm, time);
    ordered += crtk.motorOrder().released.count();
    crtk.publish(time);
    crtk.announce(Deaf{});
  }
  EXPECT_EQ(allocations() - before, 0u);
  EXPECT_TRUE(crtk.operating_state().is_homed);
  EXPECT_EQ(ordered, 4 * 100 * 7) << "in free(), with efforts, and with wrenches";
}

struct DeafToTools {
  void warning(const suture::Message&) {}
  void goal_reached(bool) {}
  void closed(bool) {}
};

TEST(JawController, NeverAllocatesInItsCycle) {
  ArmController<6> arm(psmModel());
  TrailingJoints<6> joints(psmModel(), psmParked());
  JawController jaw(
      {.lower = -1, .upper = 1, .rate_limit = 4, .acceleration_limit = 40, .effort_limit = 1}, arm);
  const JointGoal open{{0.8}, {}}, none;
  JointEffortGoal push;
  push.effort = {-0.5};
  suture::Time time = suture::fromNanoseconds(1);
  const std::uint64_t before = allocations();

  joints.step(arm, time);
  arm.obey(StateCommand::Enable);
  for (int i = 0; i < 1000; ++i) {
    time += std::chrono::milliseconds(1);
    switch (i / 100) {
      case 0: jaw.servo_jp(open); break;
      case 1: jaw.servo_jf(push); break;
      case 2: jaw.servo_jp(none); break;
      case 3: jaw.move_jp(open); break;
      case 8: arm.obey(StateCommand::Disable); break;
      default: jaw.move_jp(none);
    }
    joints.step(arm, time);
    DriveReading<6> reading;
    reading.stamp = time;
    jaw.step(time, reading);
    jaw.announce(DeafToTools{});
  }
  EXPECT_EQ(allocations() - before, 0u);
}

TEST(GripperReading, NeverAllocatesInItsCycle) {
  GripperReading gripper({.lower = 0, .upper = 1, .closed = 0, .debounce = 0});
  DriveReading<7> reading;
  const std::uint64_t before = allocations();
  for (int i = 1; i < 100; ++i) {
    reading.stamp = suture::fromNanoseconds(i);
    reading.tool.position = i % 2;
    gripper.step(reading.stamp, reading);
    gripper.announce(DeafToTools{});
  }
  EXPECT_EQ(allocations() - before, 0u);
}

/// An arm whose encoders jump composes a text that names the joint.
TEST(CrtkArm, NeverAllocatesWhenItFails) {
  ArmModel<6> model = psmModel();
  model.watch = {.jump_factor = 2};
  ArmController<6> arm(model);
  TrailingJoints<6> joints(model, psmParked());
  CrtkArm<6> crtk(arm);
  suture::Time time = suture::fromNanoseconds(1);
  joints.step(arm, time);
  const std::uint64_t before = allocations();
  crtk.enable();
  for (int i = 0; i < 20; ++i) {
    if (i == 10) joints.displace(1, 0.2);
    time += std::chrono::milliseconds(1);
    joints.step(arm, time);
    crtk.publish(time);
    crtk.announce(Deaf{});
  }
  EXPECT_EQ(allocations() - before, 0u);
  EXPECT_EQ(crtk.operating_state().state, ArmState::Fault);
}

}  // namespace
}  // namespace robots::test
