// These send goals beyond a joint limit, and goals that lie too far away for one step.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "unit/arm/crtk_arm_fixture.h"

namespace robots::test {
namespace {

class LimitsTest : public CrtkArmTest {
 protected:
  using Joints = Eigen::Matrix<double, 6, 1>;
  static constexpr int kInsertion = 2;

  /// Close to the end of the insertion.
  explicit LimitsTest(const ArmModel<6>& model = psmModel()) : CrtkArmTest(model) {
    crtk_.move_jp(toGoal(at(0.235)));
    while (crtk_.operating_state().sub_state != "holding") cycles(1);
    heard_ = {};
  }

  double deepest() const { return chain_.upper()[kInsertion]; }
  static Joints at(double insertion) {
    Joints q = Joints::Constant(0.1);
    q[kInsertion] = insertion;
    return q;
  }
  static JointGoal toGoal(const Joints& q) { return {{q.data(), q.data() + q.size()}, {}}; }
  PoseStamped toPose(const Joints& q) const { return {chain_.forward(q), {}, true}; }
  template <class Servo>
  void expectSlides(const Servo& servo) {
    for (int i = 1; i <= 20; ++i) {
      Joints q = at(deepest() + 0.001 * i);
      q[0] += 0.001 * i;
      servo(q);
      cycles(1);
      EXPECT_EQ(setpoint(kInsertion), deepest()) << i;
      EXPECT_NEAR(setpoint(0), q[0], 1e-4) << i << ": along the limit it follows";
    }
    ASSERT_EQ(heard_.warnings.size(), 1u) << "it says so, once";
    EXPECT_NE(heard_.warnings[0].find("slides"), std::string::npos) << heard_.warnings[0];
    servo(at(0.237));
    cycles(1);
    EXPECT_NEAR(setpoint(kInsertion), 0.237, 1e-6) << "it comes back with the goal";
    EXPECT_EQ(heard_.warnings.size(), 1u);
    servo(at(deepest() + 0.01));
    cycles(1);
    EXPECT_EQ(heard_.warnings.size(), 2u) << "what begins anew is news";
  }
  /// `follow` streams a rate of each joint.
  template <class Follow>
  void expectStreamSlides(const Follow& follow) {
    Joints rate = Joints::Zero();
    rate[0] = 0.5;
    rate[kInsertion] = 1;
    const double before = setpoint(0);
    for (int i = 0; i < 20; ++i) {
      follow(rate);
      cycles(1);
    }
    EXPECT_EQ(setpoint(kInsertion), deepest());
    EXPECT_NEAR(setpoint(0), before + 0.01, 1e-3) << "along the limit it follows";
    ASSERT_EQ(heard_.warnings.size(), 1u) << "it says so, once";
    EXPECT_NE(heard_.warnings[0].find("slides"), std::string::npos) << heard_.warnings[0];
    rate[kInsertion] = -1;
    follow(rate);
    cycles(1);
    EXPECT_LT(setpoint(kInsertion), deepest());
    rate[kInsertion] = 1;
    for (int i = 0; i < 5; ++i) {
      follow(rate);
      cycles(1);
    }
    EXPECT_EQ(heard_.warnings.size(), 2u) << "what begins anew is news";
  }
  template <class Servo>
  void expectRefused(const char* what, const Servo& servo) {
    crtk_.hold();
    cycles(1);
    heard_ = {};
    const std::vector<double> before = positions();
    for (int i = 0; i < 5; ++i) {
      servo();
      cycles(1);
    }
    EXPECT_EQ(positions(), before) << what;
    ASSERT_EQ(heard_.warnings.size(), 1u) << what;
    EXPECT_NE(heard_.warnings[0].find("farther"), std::string::npos) << heard_.warnings[0];
  }

  const kinematics::Chain<6> chain_ = kinematics::psm();
};

TEST_F(LimitsTest, AJointGoalSlidesAlongALimit) {
  expectSlides([&](const Joints& q) { crtk_.servo_jp(toGoal(q)); });
}

TEST_F(LimitsTest, APoseSlidesAlongALimit) {
  expectSlides([&](const Joints& q) { crtk_.servo_cp(toPose(q)); });
}

TEST_F(LimitsTest, AVelocitySlidesAlongALimit) {
  expectStreamSlides([&](const Joints& rate) {
    JointVelocityGoal goal;
    goal.goal.assign(rate.data(), rate.data() + rate.size());
    crtk_.servo_jv(goal);
  });
}

TEST_F(LimitsTest, ATwistSlidesAlongALimit) {
  expectStreamSlides([&](const Joints& rate) {
    const Joints q = Joints::Map(positions().data());
    const kinematics::SpatialVector twist = chain_.jacobian(q) * rate;
    TwistGoal goal;
    goal.linear = twist.head<3>();
    goal.angular = twist.tail<3>();
    crtk_.servo_cv(goal);
  });
}

TEST_F(LimitsTest, SlidingEndsWithAnotherCommand) {
  crtk_.servo_jp(toGoal(at(deepest() + 0.01)));
  cycles(1);
  crtk_.hold();
  crtk_.servo_jp(toGoal(at(deepest() + 0.01)));
  cycles(1);
  EXPECT_EQ(heard_.warnings.size(), 2u);
}

// The rates of this arm are 4 rad/s and 4 m/s, its horizon is 0.1 s.
TEST_F(LimitsTest, AGoalBeyondOneStepIsRefused) {
  Joints far = at(0.235), near = far;
  far[0] += 0.41;
  near[0] += 0.3;
  expectRefused("servo_jp", [&] { crtk_.servo_jp(toGoal(far)); });
  expectRefused("servo_cp", [&] { crtk_.servo_cp(toPose(far)); });
  Joints step = Joints::Zero();
  step[0] = 0.41;
  expectRefused("servo_jr", [&] { crtk_.servo_jr(toGoal(step)); });
  crtk_.servo_jp(toGoal(near));
  cycles(1);
  EXPECT_NEAR(setpoint(0), near[0], 1e-9);
}

/// Its joints may trail by more than the horizon, as those of the arms that a deployment has.
struct ServoHorizon : LimitsTest {
  static constexpr double kRate = 4, kHorizon = 0.1, kCycle = 0.001;  // rad/s, s

  ServoHorizon() : LimitsTest(roomyModel()) {}
  static ArmModel<6> roomyModel() {
    ArmModel<6> model = psmModel();
    model.following_error.setConstant(1);
    return model;
  }
};

// Each goal lies near the one before it.
TEST_F(ServoHorizon, RefusesATooFastStream) {
  Joints goal = at(0.235);
  crtk_.servo_jp(toGoal(goal));
  cycles(1);
  const double begin = setpoint(0);
  for (int i = 1; i <= 20; ++i) {
    goal[0] += 0.03;
    crtk_.servo_jp(toGoal(goal));
    cycles(1);
    ASSERT_LE(setpoint(0) - begin, kRate * (i * kCycle + kHorizon) + 1e-9) << "in cycle " << i;
  }
  ASSERT_EQ(heard_.warnings.size(), 1u);
  EXPECT_NE(heard_.warnings[0].find("farther"), std::string::npos) << heard_.warnings[0];
  EXPECT_EQ(crtk_.operating_state().state, ArmState::Enabled);
}

TEST_F(ServoHorizon, DoesNotBeginAnewWithEachHold) {
  Joints goal = at(0.235);
  const double begin = setpoint(0);
  for (int i = 1; i <= 5; ++i) {
    goal[0] += 0.3;
    crtk_.servo_jp(toGoal(goal));
    crtk_.hold();
    cycles(1);
    ASSERT_LE(setpoint(0) - begin, kRate * (i * kCycle + kHorizon) + 1e-9) << "in cycle " << i;
  }
}

TEST_F(ServoHorizon, ObeysAStreamAtTheRates) {
  Joints goal = at(0.235);
  for (int i = 0; i < 250; ++i) {
    goal[0] += kRate * kCycle;
    crtk_.servo_jp(toGoal(goal));
    cycles(1);
  }
  EXPECT_NEAR(setpoint(0), goal[0], 1e-9);
  EXPECT_TRUE(heard_.warnings.empty());
}

TEST_F(LimitsTest, ATooFarGoalEndsAStream) {
  crtk_.servo_jp(toGoal(at(0.235)));
  cycles(1);
  Joints far = at(0.235);
  far[0] += 0.5;
  for (int i = 0; i < 110; ++i) {
    crtk_.servo_jp(toGoal(far));
    cycles(1);
  }
  EXPECT_EQ(crtk_.operating_state().sub_state, "holding");
}

}  // namespace
}  // namespace robots::test
