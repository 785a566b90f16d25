// A slave whose goals come too late is never reported as following, and does not lunge when they
// come in time again.

#include "integration/teleoperation/scene/followed_arms.h"

namespace robots::test {
namespace {

class FarSlave : public TeleopStates {
 protected:
  /// Goals take so much longer from now on, and so do the slave's answers.
  void delayGoals(suture::Duration by, suture::Duration answers = {}) {
    manager_.disconnect("Teleop/Slave");
    manager_.connect("Teleop/Slave", "PSM/Arm", {.delay = {.commands = by, .answers = answers}});
  }
  void expectItNeverFollows() {
    pass(200ms);  // until a slave that got goals before says that it gets none
    for (int i = 0; i < 50; ++i) {
      pass(20ms);
      ASSERT_EQ(operator_.state(), TeleopState::Preparing);
    }
    EXPECT_EQ(wayOfSlave({0.1, 0, 0}), Vector3d::Zero());
  }
};

TEST_F(FarSlave, NobodySaysThatItFollows) {
  startFollowing();
  delayGoals(50ms);
  ASSERT_TRUE(reaches(TeleopState::Preparing));
  expectItNeverFollows();
  pass(61s);
  EXPECT_EQ(operator_.state(), TeleopState::Disabled);
  EXPECT_NE(operator_.error.find("carries out no goal"), std::string::npos) << operator_.error;
}

TEST_F(FarSlave, FollowsFromWhereItIs) {
  startFollowing();
  delayGoals(50ms);
  expectItNeverFollows();
  delayGoals(10ms);
  ASSERT_TRUE(reaches(TeleopState::Following));
  pass(50ms);
  EXPECT_TRUE(slave_.pose().isApprox(poseAt({0.3, 0, 0}, -0.4), 1e-9)) << "it jumped";
}

// The hand goes on while goals are late, and the arm holds by itself meanwhile.
TEST_F(FarSlave, ForgetsWhatItMissed) {
  startFollowing();
  slave_.missGoals(true);
  EXPECT_EQ(wayOfSlave({0.2, 0.1, 0}), Vector3d::Zero());
  ASSERT_TRUE(reaches(TeleopState::Preparing));
  slave_.missGoals(false);
  ASSERT_TRUE(reaches(TeleopState::Following));
  pass(50ms);
  EXPECT_TRUE(slave_.pose().isApprox(poseAt({0.3, 0, 0}, -0.4), 1e-9)) << "it jumped";
  EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0.05, 0, 0), 1e-9));
}

// Its set-point comes back ten cycles late, and tells of motion until then.
TEST_F(FarSlave, RestsWhileTheMasterIsAligned) {
  startFollowing();
  delayGoals(5ms, 5ms);
  ASSERT_TRUE(reaches(TeleopState::Following));
  EXPECT_TRUE(operator_.teleop.lock_rotation(true));
  turnMaster(0.3);
  master_.refuseMoves(true);
  for (int i = 0; i < 50; ++i) {
    master_.place(Eigen::Translation3d(0.0002, 0, 0) * master_.pose());
    pass(1ms);
  }
  EXPECT_TRUE(operator_.teleop.lock_rotation(false));
  ASSERT_TRUE(reaches(TeleopState::Aligning));
  pass(20ms);
  const Vector3d rested = slave_.pose().translation();
  for (int i = 0; i < 50; ++i) {
    pass(1ms);
    ASSERT_TRUE(slave_.pose().translation().isApprox(rested, 1e-9)) << "it repeats its last motion";
  }
}

}  // namespace
}  // namespace robots::test
