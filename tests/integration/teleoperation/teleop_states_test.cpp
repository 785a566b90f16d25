// These are the states of a teleoperation: alignment, clutch and presence, locks, scale and view.

#include <gtest/gtest.h>

#include "integration/teleoperation/scene/followed_arms.h"

namespace robots::test {
namespace {

// A deployment connects one interface after the other, and a process may be slow.
TEST_F(TeleopStates, FollowingWaitsForThePedals) {
  leaveForLater("Pedals");
  console_.clutch = true;
  start();
  ASSERT_TRUE(reaches(TeleopState::Clutched));
  pass(1s);
  EXPECT_EQ(operator_.state(), TeleopState::Clutched);
  EXPECT_EQ(slave_.goals().size(), 0u);
  EXPECT_EQ(master_.moves(), 0u);
  connectWhatWasLeft();
  console_.clutch = false;
  EXPECT_TRUE(reaches(TeleopState::Following));
}

TEST_F(TeleopStates, AlignmentWaitsForTheRegistration) {
  leaveForLater("Registration");
  start();
  pass(1s);
  EXPECT_EQ(operator_.state(), TeleopState::Preparing);
  EXPECT_EQ(master_.moves(), 0u);
  connectWhatWasLeft();
  EXPECT_TRUE(reaches(TeleopState::Following));
}

TEST_F(TeleopStates, TheMasterIsAlignedFirst) {
  startFollowing();
  using enum TeleopState;
  const std::vector<TeleopState> told = operator_.told();
  ASSERT_GE(told.size(), 3u);
  EXPECT_EQ(std::vector(told.end() - 2, told.end()), (std::vector{Aligning, Following}));
  EXPECT_EQ(master_.moves(), 1u);
  EXPECT_TRUE(master_.pose().isApprox(poseAt({0.1, 0, 0}, -0.4), 1e-9)) << "it turns about its tip";
  EXPECT_TRUE(slave_.pose().isApprox(poseAt({0.3, 0, 0}, -0.4), 1e-9))
      << "only the master is moved";
  turnMaster(0.3);
  EXPECT_TRUE(slave_.pose().isApprox(poseAt({0.3, 0, 0}, -0.1), 1e-9));
}

TEST_F(TeleopStates, ASmallDifferenceOfOrientationStays) {
  master_.place(poseAt({0.1, 0, 0}, -0.45));
  startFollowing();
  EXPECT_EQ(master_.moves(), 0u);
  EXPECT_TRUE(slave_.pose().isApprox(poseAt({0.3, 0, 0}, -0.4), 1e-9));
}

TEST_F(TeleopStates, AStuckMasterDisablesIt) {
  master_.refuseMoves(true);
  start({.preparation_limit = 5s});
  ASSERT_TRUE(reaches(TeleopState::Aligning));
  pass(4s);
  EXPECT_EQ(operator_.state(), TeleopState::Aligning);
  EXPECT_EQ(master_.moves(), 4u) << "it is asked again each second";
  ASSERT_TRUE(reaches(TeleopState::Disabled));
  pass(5ms);
  EXPECT_NE(operator_.error.find("has not turned"), std::string::npos) << operator_.error;
  EXPECT_TRUE(slave_.pose().isApprox(poseAt({0.3, 0, 0}, -0.4), 1e-9))
      << "only the master is moved";
  EXPECT_EQ(master_.holds(), 1u) << "it may still be on its way";
}

TEST_F(TeleopStates, UnreadyArmsDisableItInTime) {
  slave_.beSilent(true);
  start({.preparation_limit = 5s});
  ASSERT_TRUE(reaches(TeleopState::Preparing));
  ASSERT_TRUE(reaches(TeleopState::Disabled));
  EXPECT_NE(operator_.error.find("not become ready"), std::string::npos) << operator_.error;
}

TEST_F(TeleopStates, EnablingAgainGivesItMoreTime) {
  slave_.beSilent(true);
  start({.preparation_limit = 5s});
  ASSERT_TRUE(reaches(TeleopState::Preparing));
  pass(4s);
  ASSERT_TRUE(operator_.teleop.enable());
  pass(4s);
  EXPECT_EQ(operator_.state(), TeleopState::Preparing) << operator_.error;
  EXPECT_TRUE(reaches(TeleopState::Disabled));
}

TEST_F(TeleopStates, TheClutchMovesNoSlave) {
  startFollowing();
  console_.clutch = true;
  expectClutchedUntil([&] { console_.clutch = false; });
}

TEST_F(TeleopStates, SoDoesTheCameraPedal) {
  startFollowing();
  console_.camera = true;
  expectClutchedUntil([&] { console_.camera = false; });
}

TEST_F(TeleopStates, LookingAwayClutchesToo) {
  startFollowing();
  console_.present = false;
  expectClutchedUntil([&] { console_.present = true; });
}

// A cable may be cut, or the task of the pedals may hang.
TEST_F(TeleopStates, SilentPedalsClutchToo) {
  startFollowing();
  console_.stuck = true;
  expectClutchedUntil([&] { console_.stuck = false; });
}

TEST_F(TeleopStates, SoDoPedalsOfTheFuture) {
  startFollowing();
  console_.ahead = 1000;
  expectClutchedUntil([&] { console_.ahead = 0; });
}

TEST_F(TeleopStates, AMasterOfTheFutureLeadsNothing) {
  startFollowing();
  master_.stampAhead(1s);
  ASSERT_TRUE(reaches(TeleopState::Preparing));
  pass(5ms);
  EXPECT_EQ(wayOfSlave({0.1, 0, 0}), Vector3d::Zero());
  master_.stampAhead(0s);
  EXPECT_TRUE(reaches(TeleopState::Following));
}

TEST_F(TeleopStates, ATurnedMasterIsAlignedAnew) {
  startFollowing();
  console_.clutch = true;
  ASSERT_TRUE(reaches(TeleopState::Clutched));
  turnMaster(1.0);
  EXPECT_EQ(master_.moves(), 1u);
  console_.clutch = false;
  ASSERT_TRUE(reaches(TeleopState::Following));
  EXPECT_EQ(master_.moves(), 2u);
  EXPECT_TRUE(master_.pose().linear().isApprox(slave_.pose().linear(), 1e-9));
  EXPECT_TRUE(slave_.pose().isApprox(poseAt({0.3, 0, 0}, -0.4), 1e-9));
}

TEST_F(TeleopStates, AnotherScaleDoesNotMoveTheSlave) {
  startFollowing();
  EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0.05, 0, 0), 1e-9));
  ASSERT_TRUE(operator_.teleop.set_scale(2));
  pass(5ms);
  EXPECT_TRUE(slave_.pose().isApprox(poseAt({0.35, 0, 0}, -0.4), 1e-9)) << "it jumped";
  EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0.2, 0, 0), 1e-9));
  EXPECT_EQ(operator_.state(), TeleopState::Following);
}

/// A master that rests sends no goals, so its arm accepts another base.
TEST_F(TeleopStates, ARestingMastersBaseMovesNoSlave) {
  startFollowing();
  const Isometry3d held = slave_.pose();
  master_.rebase({0.05, 0, 0});
  pass(100ms);
  EXPECT_TRUE(slave_.pose().isApprox(held, 1e-9)) << "it jumped";
  EXPECT_EQ(operator_.state(), TeleopState::Following);
  EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0.05, 0, 0), 1e-9));
}

TEST_F(TeleopStates, AScaleOutOfRangeIsRefused) {
  startFollowing();
  EXPECT_EQ(operator_.teleop.set_scale(0).error(), suture::Errc::Invalid);
}

TEST_F(TeleopStates, ALockedPositionStays) {
  startFollowing();
  ASSERT_TRUE(operator_.teleop.lock_translation(true));
  pass(5ms);
  EXPECT_EQ(wayOfSlave({0.1, 0.2, 0.3}), Vector3d::Zero());
  turnMaster(0.3);
  EXPECT_TRUE(slave_.pose().isApprox(poseAt({0.3, 0, 0}, -0.1), 1e-9)) << "it still turns";
  ASSERT_TRUE(operator_.teleop.lock_translation(false));
  pass(5ms);
  EXPECT_TRUE(slave_.pose().isApprox(poseAt({0.3, 0, 0}, -0.1), 1e-9)) << "it jumped";
  EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0.05, 0, 0), 1e-9));
}

TEST_F(TeleopStates, UnlockingTheOrientationAlignsTheMaster) {
  startFollowing();
  ASSERT_TRUE(operator_.teleop.lock_rotation(true));
  pass(5ms);
  turnMaster(0.7);
  EXPECT_TRUE(slave_.pose().isApprox(poseAt({0.3, 0, 0}, -0.4), 1e-9));
  EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0.05, 0, 0), 1e-9)) << "it still moves";
  EXPECT_EQ(master_.moves(), 1u);
  ASSERT_TRUE(operator_.teleop.lock_rotation(false));
  pass(20ms);
  EXPECT_EQ(operator_.state(), TeleopState::Following);
  EXPECT_EQ(master_.moves(), 2u);
  EXPECT_TRUE(master_.pose().linear().isApprox(slave_.pose().linear(), 1e-9));
  EXPECT_TRUE(slave_.pose().isApprox(poseAt({0.35, 0, 0}, -0.4), 1e-9));
}

// The camera stands on its side: what goes to the right at the console goes upward in the scene.
TEST_F(TeleopStates, DirectionsAreThoseThatTheSurgeonSees) {
  startFollowing();
  ASSERT_TRUE(operator_.registration.set_camera(poseAt({0, 0, 0.1}, EIGEN_PI / 2)));
  pass(50ms);
  EXPECT_TRUE(slave_.pose().isApprox(poseAt({0.3, 0, 0}, -0.4), 1e-9))
      << "the camera moved, no arm";
  EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0, 0.05, 0), 1e-9));
  turnMaster(0.2);
  EXPECT_TRUE(slave_.pose().isApprox(poseAt({0.3, 0.05, 0}, -0.2), 1e-9))
      << "about the line of sight";

  console_.clutch = true;
  ASSERT_TRUE(reaches(TeleopState::Clutched));
  console_.clutch = false;
  ASSERT_TRUE(reaches(TeleopState::Following));
  const Isometry3d seen = poseAt(Vector3d::Zero(), -EIGEN_PI / 2) * slave_.pose();
  EXPECT_TRUE(master_.pose().linear().isApprox(seen.linear(), 1e-9)) << "aligned in the picture";
}

TEST_F(TeleopStates, AnOldRegistrationBeginsNothing) {
  startFollowing();
  registerLate(400ms);
  pass(1s);
  EXPECT_EQ(operator_.state(), TeleopState::Following);
  EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0.05, 0, 0), 1e-9));
  console_.clutch = true;
  pass(20ms);
  console_.clutch = false;
  pass(1s);
  EXPECT_EQ(operator_.state(), TeleopState::Preparing);
  EXPECT_EQ(wayOfSlave({0.1, 0, 0}), Vector3d::Zero());
  registerLate(0ms);
  ASSERT_TRUE(reaches(TeleopState::Following));
  pass(5ms);
  EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0.05, 0, 0), 1e-9));
}

TEST_F(TeleopStates, ARoundedRotationIsMadeExact) {
  startFollowing();
  Isometry3d camera = Isometry3d::Identity();
  camera.linear().topLeftCorner<2, 2>() << 0.707107, -0.707107, 0.707107, 0.707107;
  ASSERT_TRUE(operator_.registration.set_camera(camera));
  pass(50ms);
  wayOfSlave({0.1, 0, 0});
  ASSERT_FALSE(slave_.goals().empty());
  const Eigen::Matrix3d turned = slave_.goals().back().pose.linear();
  EXPECT_TRUE((turned * turned.transpose()).isIdentity(1e-12));
}

// No goal leads there while its tool is not in, so the operator must not believe that it follows.
TEST_F(TeleopStates, ARefusingSlaveDisablesIt) {
  startFollowing();
  slave_.warn(ArmWarning::NotInserted);
  ASSERT_TRUE(reaches(TeleopState::Disabled));
  pass(5ms);
  EXPECT_NE(operator_.error.find("refuses its goals"), std::string::npos) << operator_.error;
  EXPECT_EQ(slave_.holds(), 1u);
}

/// An arm tells all clients what it refuses any of them.
TEST_F(TeleopStates, AnotherClientsRefusalDisablesNothing) {
  startFollowing();
  slave_.warn(ArmWarning::Malformed);
  pass(50ms);
  EXPECT_EQ(operator_.state(), TeleopState::Following);
}

TEST_F(TeleopStates, AMasterWithoutRigidPoseLeadsNothing) {
  startFollowing();
  Isometry3d bent = master_.pose();
  bent.linear()(0, 1) += 1e-3;
  master_.place(bent);
  ASSERT_TRUE(reaches(TeleopState::Preparing));
}

TEST_F(TeleopStates, ASmallTurnDoesNotEndFollowing) {
  startFollowing();
  ASSERT_TRUE(operator_.teleop.lock_rotation(true));
  pass(5ms);
  turnMaster(0.05);
  ASSERT_TRUE(operator_.teleop.lock_rotation(false));
  pass(5ms);
  EXPECT_EQ(master_.moves(), 1u);
  EXPECT_EQ(operator_.state(), TeleopState::Following);
  EXPECT_TRUE(slave_.pose().isApprox(poseAt({0.3, 0, 0}, -0.4), 1e-9)) << "it jumped";
}

TEST_F(TeleopStates, AnInvalidRotationIsNotRegistered) {
  startFollowing();
  Isometry3d mirrored = Isometry3d::Identity();
  mirrored.linear().col(0) *= -1;
  ASSERT_TRUE(operator_.registration.set_camera(mirrored));
  pass(50ms);
  EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0.05, 0, 0), 1e-9));
}

}  // namespace
}  // namespace robots::test
