// A teleoperation that is suspended, disabled or faulted leaves no arm on its way.

#include <gtest/gtest.h>

#include <stdexcept>

#include "integration/teleoperation/scene/followed_arms.h"

namespace robots::test {
namespace {

class TeleopRest : public TeleopStates {};

TEST_F(TeleopRest, ASuspendStopsATurningMaster) {
  master_.refuseMoves(true);
  start();
  ASSERT_TRUE(reaches(TeleopState::Aligning));
  manager_.suspend("Teleop");
  EXPECT_TRUE(suture::clockOfTest().until([&] { return master_.holds() == 1; }));
}

TEST_F(TeleopRest, SuspendingStopsAnArmOnItsWay) {
  slave_.forgetHome();
  start();
  ASSERT_TRUE(suture::clockOfTest().until([&] { return slave_.homes() == 1; }));
  pass(50ms);
  EXPECT_EQ(slave_.holds(), 0u);
  manager_.suspend("Teleop");
  EXPECT_TRUE(suture::clockOfTest().until([&] { return slave_.holds() == 1; }));
  pass(50ms);
  manager_.resume("Teleop");
  EXPECT_TRUE(suture::clockOfTest().until([&] { return slave_.homes() == 2; }));
}

TEST_F(TeleopRest, DisablingStopsAnArmThatItHomes) {
  master_.forgetHome();
  start();
  ASSERT_TRUE(suture::clockOfTest().until([&] { return master_.homes() == 1; }));
  pass(50ms);
  ASSERT_TRUE(operator_.teleop.disable());
  EXPECT_TRUE(suture::clockOfTest().until([&] { return master_.holds() == 1; }));
  pass(50ms);
  EXPECT_EQ(master_.homes(), 1u);
}

TEST_F(TeleopRest, DisablingLeavesAnArmOfAnother) {
  slave_.forgetHome();
  slave_.home();
  start();
  ASSERT_TRUE(reaches(TeleopState::Preparing));
  pass(50ms);
  ASSERT_TRUE(operator_.teleop.disable());
  ASSERT_TRUE(reaches(TeleopState::Disabled));
  pass(50ms);
  EXPECT_EQ(slave_.homes(), 1u);
  EXPECT_EQ(slave_.holds(), 0u);
}

/// It must not go on by itself, because nobody knows yet why it faulted.
TEST_F(TeleopRest, AFaultStopsAndDisablesTheSlave) {
  startFollowing();
  teleop_->parkSoonOnThrow([] { throw std::runtime_error("a bad number"); });
  ASSERT_TRUE(suture::clockOfTest().until([&] { return slave_.holds() == 1; }));
  pass(1s);
  EXPECT_EQ(teleop_->state(), suture::ComponentState::Running) << "it was restarted";
  EXPECT_EQ(operator_.state(), TeleopState::Disabled);
  EXPECT_EQ(wayOfSlave({0.1, 0, 0}), Vector3d::Zero());
  ASSERT_TRUE(operator_.teleop.enable());
  ASSERT_TRUE(reaches(TeleopState::Following));
  pass(5ms);
  EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0.05, 0, 0), 1e-9));
}

TEST_F(TeleopRest, AFaultStopsATurningMaster) {
  master_.refuseMoves(true);
  start();
  ASSERT_TRUE(reaches(TeleopState::Aligning));
  teleop_->parkSoonOnThrow([] { throw std::runtime_error("a bad number"); });
  EXPECT_TRUE(suture::clockOfTest().until([&] { return master_.holds() == 1; }));
}

TEST_F(TeleopRest, ARestDoesNotCountAsPreparation) {
  start({.scale = 0.5, .preparation_limit = 1s});
  ASSERT_TRUE(reaches(TeleopState::Following));
  manager_.suspend("Teleop");
  pass(2s);
  turnMaster(0.3);
  manager_.resume("Teleop");
  pass(20ms);
  EXPECT_NE(operator_.state(), TeleopState::Disabled) << operator_.error;
  EXPECT_TRUE(reaches(TeleopState::Following));
}

}  // namespace
}  // namespace robots::test
