// A master that a hand moves floats while it is the surgeon's to move, and holds otherwise.

#include <gtest/gtest.h>

#include "integration/teleoperation/scene/followed_arms.h"

namespace robots::test {
namespace {

class MasterRelease : public TeleopStates {
 protected:
  void follow(bool releases = true) {
    start({.scale = 0.5, .release_master = releases});
    ASSERT_TRUE(reaches(TeleopState::Following));
    pass(5ms);
    master_.forgetGoals();
    holds_ = master_.holds();
  }
  /// Returns the wrenches that the master gets in 50 ms from now on.
  std::vector<WrenchGoal> wrenchesMeanwhile() {
    pass(2ms);
    master_.forgetGoals();
    pass(50ms);
    return master_.wrenches();
  }
  void expectFloating() {
    const std::vector<WrenchGoal> wrenches = wrenchesMeanwhile();
    EXPECT_GT(wrenches.size(), 40u) << "its stream would end";
    for (const WrenchGoal& one : wrenches) {
      EXPECT_EQ(one.force, Vector3d::Zero());
      EXPECT_EQ(one.torque, Vector3d::Zero());
    }
    EXPECT_EQ(master_.holds(), holds_);
  }
  void expectHeld() {
    EXPECT_TRUE(wrenchesMeanwhile().empty());
    EXPECT_EQ(master_.holds(), holds_ + 1);
  }

  std::size_t holds_ = 0;
};

TEST_F(MasterRelease, FloatsWhileTheSlaveFollows) {
  follow();
  expectFloating();
  EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0.05, 0, 0), 1e-9));
}

TEST_F(MasterRelease, FloatsWhileTheClutchIsPressed) {
  follow();
  console_.clutch = true;
  ASSERT_TRUE(reaches(TeleopState::Clutched));
  expectFloating();
}

TEST_F(MasterRelease, HoldsWithoutASurgeon) {
  follow();
  console_.present = false;
  ASSERT_TRUE(reaches(TeleopState::Clutched));
  expectHeld();
}

TEST_F(MasterRelease, HoldsWhenASurgeonLeavesThePedal) {
  follow();
  console_.clutch = true;
  ASSERT_TRUE(reaches(TeleopState::Clutched));
  expectFloating();
  console_.present = false;
  pass(2ms);
  expectHeld();
}

TEST_F(MasterRelease, HoldsWhenItIsDisabled) {
  follow();
  ASSERT_TRUE(operator_.teleop.disable());
  ASSERT_TRUE(reaches(TeleopState::Disabled));
  expectHeld();
}

TEST_F(MasterRelease, HoldsWithoutDataOfTheSlave) {
  follow();
  slave_.beSilent(true);
  ASSERT_TRUE(reaches(TeleopState::Preparing));
  expectHeld();
}

TEST_F(MasterRelease, HoldsWhileItIsTurned) {
  follow();
  console_.clutch = true;
  ASSERT_TRUE(reaches(TeleopState::Clutched));
  turnMaster(0.5);
  master_.refuseMoves(true);
  console_.clutch = false;
  ASSERT_TRUE(reaches(TeleopState::Aligning));
  expectHeld();
}

TEST_F(MasterRelease, HoldsWhenItsTaskIsSuspended) {
  follow();
  manager_.suspend("Teleop");
  expectHeld();
}

TEST_F(MasterRelease, LeavesAMasterAloneByDefault) {
  follow(false);
  EXPECT_TRUE(wrenchesMeanwhile().empty());
  EXPECT_EQ(master_.holds(), holds_);
}

}  // namespace
}  // namespace robots::test
