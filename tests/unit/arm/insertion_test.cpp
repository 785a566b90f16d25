// These tests send Cartesian goals to an arm that works through a cannula.

#include <gtest/gtest.h>

#include <vector>

#include "unit/arm/crtk_arm_fixture.h"

namespace robots::test {
namespace {

ArmModel<6> cannulaModel() {
  ArmModel<6> model = psmModel();
  model.insertion = InsertionRule{.joints = 4, .least = 0.045, .buffer = 0.002};
  return model;
}

class InsertionTest : public CrtkArmTest {
 protected:
  // In m: this is the insertion joint's position less how far the wrist is beyond the centre.
  static constexpr double kShaft = 0.4318 - 0.4162;

  InsertionTest() : CrtkArmTest(cannulaModel()) {}

  /// Brings the wrist this many m beyond the remote centre by a joint move.
  void insert(double wristBeyondCentre) {
    JointGoal goal = joints(0.1);
    goal.position[2] = wristBeyondCentre + kShaft;
    heard_ = {};
    crtk_.move_jp(goal);
    while (heard_.goals.empty()) cycles(1);
    cycles(200);
    heard_ = {};
  }
  bool obeysServo() {
    heard_ = {};
    crtk_.servo_cp(crtk_.setpoint_cp());
    cycles(1);
    const bool obeys = crtk_.operating_state().sub_state == "servo_cp";
    EXPECT_EQ(obeys, heard_.codes.empty());
    crtk_.hold();
    cycles(1);
    return obeys;
  }
};

TEST_F(InsertionTest, CartesianCommandsNeedInsertion) {
  insert(0.04);
  expectTipRefused(ArmWarning::NotInserted);
}

TEST_F(InsertionTest, BeginsBeyondItsBuffer) {
  insert(0.04);
  EXPECT_FALSE(obeysServo());
  insert(0.046);
  EXPECT_FALSE(obeysServo());
  insert(0.048);
  EXPECT_TRUE(obeysServo());
  insert(0.046);
  EXPECT_TRUE(obeysServo()) << "it has begun";
  insert(0.044);
  EXPECT_FALSE(obeysServo());
}

TEST_F(InsertionTest, AStreamEndsWithoutInsertion) {
  insert(0.05);
  TwistGoal outwards;
  outwards.linear = -0.02 * crtk_.setpoint_cp().pose.translation().normalized();
  for (int i = 0; i < 1000 && heard_.codes.empty(); ++i) {
    crtk_.servo_cv(outwards);
    cycles(1);
  }
  EXPECT_EQ(heard_.codes, std::vector{ArmWarning::NotInserted});
  cycles(1);
  EXPECT_EQ(crtk_.operating_state().sub_state, "holding");
  EXPECT_NEAR(setpoint(2), 0.045 + kShaft, 1e-3);
}

TEST_F(InsertionTest, HomingInsertsTheInstrument) {
  insert(0.03);
  crtk_.home();
  while (heard_.goals.empty()) cycles(1);
  cycles(50);
  EXPECT_TRUE(obeysServo());
}

}  // namespace
}  // namespace robots::test
