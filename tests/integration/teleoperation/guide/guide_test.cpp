// The guide of a knot does not act on what is old or unseen, and knows where the slaves really are.

#include <gtest/gtest.h>
#include <suture/base/errors.h>

#include <cmath>
#include <stdexcept>

#include "integration/teleoperation/scene/guided_arms.h"
#include "support/refusal.h"

namespace robots::test {
namespace {

// The guide sends at most this far from where a slave is, by data as old as allowed.
constexpr double kMostAstray = 0.004;  // m

/// Returns how far it is turned about z, rad.
double angleOf(const Eigen::Isometry3d& pose) {
  return std::atan2(pose.linear()(1, 0), pose.linear()(0, 0));
}

TEST_F(Guide, HasBothSlavesFollowTheirMasters) { expectThatBothFollow(); }

TEST_F(Guide, OldDataHoldBothSlaves) {
  for (ScriptedArm& arm : arms_) {
    arm.beSilent(true);
    ASSERT_TRUE(becomes(GuidanceState::Preparing));
    pass(2ms);
    forgetGoals();
    moveMasters({0, 0, 0.02}, 50);
    EXPECT_EQ(goals(), 0u);

    const Vector3d leftHeld = left(), rightHeld = right();
    arm.beSilent(false);
    ASSERT_TRUE(suture::clockOfTest().until([&] { return goals() >= 2; }));
    EXPECT_TRUE(left().isApprox(leftHeld, 1e-9)) << "it jumped";
    EXPECT_TRUE(right().isApprox(rightHeld, 1e-9)) << "it jumped";
    expectThatBothFollow();
  }
}

// A slave that is not told takes a stream that ends for one that has failed, 0.1 s later.
TEST_F(Guide, TellsBothSlavesOnceToHold) {
  eyes_.covered = true;
  ASSERT_TRUE(becomes(GuidanceState::Blind));
  pass(50ms);
  EXPECT_EQ(arms_[2].holds(), 1u);
  EXPECT_EQ(arms_[3].holds(), 1u);
}

TEST_F(Guide, AnUnseenKnotHoldsBothSlaves) {
  eyes_.covered = true;
  ASSERT_TRUE(becomes(GuidanceState::Blind));
  pass(2ms);
  forgetGoals();
  const Vector3d leftHeld = left(), rightHeld = right();
  moveMasters({0, 0, 0.02}, 50);
  EXPECT_EQ(goals(), 0u);
  eyes_.covered = false;
  ASSERT_TRUE(becomes(GuidanceState::Guiding));
  pass(2ms);
  EXPECT_TRUE(left().isApprox(leftHeld, 1e-9)) << "it jumped";
  EXPECT_TRUE(right().isApprox(rightHeld, 1e-9)) << "it jumped";
  expectThatBothFollow();
}

TEST_F(Guide, BeginsAnewWhereASlaveRefuses) {
  arms_[3].place(Eigen::Translation3d(0.02, 0, 0) * arms_[3].pose());
  arms_[3].refuseStepsBeyond(0.003);
  const Vector3d before = right();
  pass(30ms);
  EXPECT_LT((right() - before).norm(), 1e-3);
  expectThatBothFollow();
}

/// It has not seen where the masters and the slaves went, and all data are fresh when it looks
/// again.
TEST_F(Guide, BeginsAnewAfterItWasSuspended) {
  pass(50ms);
  manager_.suspend("Guide");
  moveMasters({0, 0, 0.02}, 50);
  for (ScriptedArm* slave : {&arms_[2], &arms_[3]}) {
    slave->place(Eigen::Translation3d(0, 0.01, 0) * slave->pose());
  }
  pass(20ms);
  const Vector3d leftHeld = left(), rightHeld = right();
  manager_.resume("Guide");
  pass(50ms);  // until an image of afterwards has come
  ASSERT_EQ(guide_.guidance_state(), GuidanceState::Guiding);
  EXPECT_TRUE(left().isApprox(leftHeld, 1e-9)) << "it jumped";
  EXPECT_TRUE(right().isApprox(rightHeld, 1e-9)) << "it jumped";
  EXPECT_TRUE(guide_.progress().knot.isApprox(eyes_.seen_.knot, 1e-9))
      << "an earlier image was matched with tips that had moved since";
  expectThatBothFollow();
}

TEST_F(Guide, IsNotGuidingWhileSuspended) {
  manager_.suspend("Guide");
  EXPECT_TRUE(becomes(GuidanceState::Preparing));
  EXPECT_FALSE(guide_.progress().valid);
  pass(20ms);
  listener_.processEvents();
  EXPECT_EQ(listener_.state, GuidanceState::Preparing);
  manager_.resume("Guide");
  EXPECT_TRUE(becomes(GuidanceState::Guiding));
}

TEST_F(Guide, SuspendingStopsAnArmOnItsWay) {
  arms_[2].forgetHome();
  ASSERT_TRUE(becomes(GuidanceState::Preparing));
  guide_.enable();
  ASSERT_TRUE(suture::clockOfTest().until([&] { return arms_[2].homes() == 1; }));
  pass(50ms);
  EXPECT_EQ(arms_[2].holds(), 0u);
  manager_.suspend("Guide");
  EXPECT_TRUE(suture::clockOfTest().until([&] { return arms_[2].holds() == 1; }));
  manager_.resume("Guide");
  ASSERT_TRUE(suture::clockOfTest().until([&] { return arms_[2].homes() == 2; }));
  pass(50ms);
  ASSERT_TRUE(listener_.guidance.disable());
  EXPECT_TRUE(suture::clockOfTest().until([&] { return arms_[2].holds() == 2; }));
}

/// It must not go on by itself, because nobody knows yet why it faulted.
TEST_F(Guide, HoldsAndIsDisabledAfterAFault) {
  guide_.parkSoonOnThrow([] { throw std::runtime_error("a bad number"); });
  ASSERT_TRUE(suture::clockOfTest().until([&] { return arms_[2].holds() == 1; }));
  EXPECT_EQ(arms_[3].holds(), 1u);
  pass(1s);
  EXPECT_EQ(guide_.state(), suture::ComponentState::Running) << "it was restarted";
  EXPECT_EQ(guide_.guidance_state(), GuidanceState::Disabled);
  expectThatItWaitsForEnable();
}

/// Its reads go on while its commands wait for the operator.
TEST_F(Guide, IsNotGuidingWithoutTheSlavesGoals) {
  manager_.disconnect("Guide/RightSlave");
  manager_.connect("Guide/RightSlave", "RightSlave/Arm",
                   {.contract = {.maxAge = 20ms, .resume = suture::Resume::Operator}});
  ASSERT_TRUE(becomes(GuidanceState::Guiding));
  arms_[3].beSilent(true);
  ASSERT_TRUE(becomes(GuidanceState::Preparing));
  arms_[3].beSilent(false);
  pass(50ms);  // until an image of afterwards has come
  listener_.processEvents();
  listener_.heard = 0;
  pass(10ms);
  listener_.processEvents();
  EXPECT_EQ(listener_.heard, 0u) << "it changes its mind in each cycle";
  EXPECT_EQ(guide_.guidance_state(), GuidanceState::Preparing);
  manager_.resumeConnection("Guide/RightSlave");
  ASSERT_TRUE(becomes(GuidanceState::Guiding));
  expectThatBothFollow();
}

/// It would catch up at once when the limit ends, by a way that no fixture has looked at.
TEST_F(Guide, StaysNearASlaveAtALimit) {
  arms_[2].stayAbove(-0.031);
  forgetGoals();
  moveMasters({0, 0, -0.1}, 1000);
  for (const PoseStamped& goal : arms_[2].goals()) {
    ASSERT_GT(goal.pose.translation().z(), -0.031 - kMostAstray);
  }
  EXPECT_GT(goals(), 1000u) << "the other one would follow no more";
}

/// Its slave would slide along the limit and be told of as one that has gone astray.
TEST_F(Guide, LeadsNoSlaveBeyondItsJoints) {
  constexpr double kLimit = -0.035;
  arms_[2].beAGantryAbove(kLimit);
  arms_[2].stayAbove(kLimit);
  pass(10ms);
  forgetGoals();
  moveMasters({0, 0, -0.1}, 1000);
  EXPECT_NEAR(left().z(), kLimit, 1e-6);
  for (const PoseStamped& goal : arms_[2].goals()) {
    ASSERT_GT(goal.pose.translation().z(), kLimit - 1e-9);
  }
  EXPECT_GE(goals(), 2000u) << "it began anew";
  const double rightBefore = right().z();
  moveMasters({0, 0, 0.1}, 1000);
  pass(5ms);
  EXPECT_NEAR(right().z() - rightBefore, 0.04, 1e-3);
  EXPECT_NEAR(left().z(), kLimit + 0.03, 1e-3) << "the rest of what they forbade is forgotten";
}

/// A knot that is estimated by them is behind the tips that are led.
TEST_F(Guide, LateSlavesKeepTheKnotInside) {
  const GuideParameters corridor;
  eyes_.seen_.knot.x() = 0.02;
  for (ScriptedArm* slave : {&arms_[2], &arms_[3]}) slave->answerLate(15);
  pass(300ms);
  ASSERT_NEAR(guide_.progress().knot.x(), 0.02, 1e-6);
  eyes_.covered = true;  // these see a knot that does not move
  const Vector3d before = (left() + right()) / 2;
  moveMasters({0.05, 0, 0}, 150);
  pass(20ms);
  ASSERT_EQ(guide_.guidance_state(), GuidanceState::Guiding);
  const Vector3d knot = eyes_.seen_.knot + (left() + right()) / 2 - before;
  const double ahead = knot.z() - corridor.target.z();
  EXPECT_NEAR(knot.x(), corridor.radius + corridor.slope * ahead, 1e-5) << "it went along its edge";
}

/// An arm would slide along the limit, and its tip would leave the way that the fixtures permit.
TEST_F(Guide, TurnsNoSlaveBeyondItsJoints) {
  constexpr double kLimit = 0.1;
  arms_[2].beAGantryAbove(-1);
  arms_[2].turnUpTo(kLimit);
  pass(10ms);
  forgetGoals();
  turnMasters(0.3, 300);
  for (const PoseStamped& goal : arms_[2].goals()) ASSERT_LT(angleOf(goal.pose), kLimit + 1e-6);
  EXPECT_NEAR(angleOf(arms_[2].pose()), kLimit, 1e-3);
  EXPECT_NEAR(angleOf(arms_[3].pose()), 0.3, 1e-6) << "the other one turns on";
  expectThatBothFollow();
  turnMasters(-0.3, 300);
  EXPECT_NEAR(angleOf(arms_[2].pose()), 0, 1e-6) << "it came back with the hand";
}

/// A camera that is moved must not let the tool catch up with a hand beyond its joints.
TEST_F(Guide, AMovedCameraOverstretchesNoSlave) {
  arms_[2].beAGantryAbove(-1);
  arms_[2].turnUpTo(0.1);
  pass(10ms);
  turnMasters(0.3, 300);
  Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();
  camera.rotate(Eigen::AngleAxisd(0.2, Vector3d::UnitX()));
  registration_.set_camera(camera);
  pass(50ms);
  EXPECT_NEAR(angleOf(arms_[2].pose()), 0.1, 1e-3);
}

/// Its joints are about its base, and its poses in the frame in which somebody has set that.
TEST_F(Guide, AMovedBaseOverreachesNoSlave) {
  constexpr double kLimit = -0.035;
  arms_[2].beAGantryAbove(kLimit);
  arms_[2].hangUpsideDown();
  pass(10ms);
  forgetGoals();
  moveMasters({0, 0, -0.1}, 1000);
  EXPECT_NEAR(left().z(), kLimit, 1e-6);
  for (const PoseStamped& goal : arms_[2].goals()) {
    ASSERT_GT(goal.pose.translation().z(), kLimit - 1e-9);
  }
}

// No goal leads there while its tool is not in, so the surgeon must not believe that it is guided.
TEST_F(Guide, ARefusingSlaveDisablesIt) {
  for (ScriptedArm* slave : {&arms_[2], &arms_[3]}) {
    slave->warn(ArmWarning::NotInserted);
    ASSERT_TRUE(becomes(GuidanceState::Disabled));
    pass(2ms);
    ASSERT_TRUE(complaints_.processEvents());
    EXPECT_NE(complaints_.error.find("refuses its goals"), std::string::npos) << complaints_.error;
    complaints_.error.clear();
    expectThatItWaitsForEnable();
  }
}

TEST_F(Guide, IsDisabledWhenAnArmStaysUnready) {
  arms_[3].beSilent(true);
  ASSERT_TRUE(becomes(GuidanceState::Preparing));
  pass(kPreparationLimit - 100ms);
  guide_.enable();
  pass(kPreparationLimit - 100ms);
  EXPECT_EQ(guide_.guidance_state(), GuidanceState::Preparing) << "it was enabled again";
  manager_.suspend("Guide");
  pass(kPreparationLimit);
  manager_.resume("Guide");
  pass(100ms);
  EXPECT_EQ(guide_.guidance_state(), GuidanceState::Preparing) << "a rest is no preparation";
  ASSERT_TRUE(becomes(GuidanceState::Disabled));
  pass(2ms);
  ASSERT_TRUE(complaints_.processEvents());
  EXPECT_NE(complaints_.error.find("not become ready"), std::string::npos) << complaints_.error;
}

TEST_F(Guide, FollowsNothingWhileItIsDisabled) {
  ASSERT_EQ(guide_.guidance_state(), GuidanceState::Guiding);
  guide_.disable();
  pass(2ms);
  forgetGoals();
  moveMasters({0, 0, 0.02}, 50);
  EXPECT_EQ(goals(), 0u);
  EXPECT_EQ(guide_.guidance_state(), GuidanceState::Disabled);
  guide_.enable();
  ASSERT_TRUE(becomes(GuidanceState::Guiding));
  expectThatBothFollow();
}

TEST(KnotGuide, RefusesAnImpossibleAge) {
  EXPECT_EQ(suture::refusal([] { KnotGuide({.sighting_age = -250ms}); }),
            "judging data by \"sighting_age\" of -0.250000 s: an age is longer than nothing and at "
            "most a minute. Set it to so many seconds, e.g. 0.25");
  for (const suture::Duration age : {suture::Duration(-5ms), suture::Duration(0),
                                     suture::Duration(std::chrono::seconds(1'000'000'000))}) {
    EXPECT_NE(suture::refusal([&] { KnotGuide({.sighting_age = age}); }), "");
    EXPECT_NE(suture::refusal([&] { KnotGuide({.max_age = age}); }), "");
    EXPECT_NE(suture::refusal([&] { KnotGuide({.registration_age = age}); }), "");
    EXPECT_NE(suture::refusal([&] { KnotGuide({.operator_age = age}); }), "");
  }
}

TEST(KnotGuide, RefusesAnImpossibleScaleOrLine) {
  EXPECT_TRUE(
      suture::refusal([] { KnotGuide({.scale = -1}); })
          .ends_with("a slave can only follow with a finite scale above zero. Set \"scale\" "
                     "to slave metres a master metre, e.g. 0.2"));
  EXPECT_EQ(suture::refusal([] {
              KnotGuide({.approach = {0, 0, 0}});
            }),
            "guiding a knot along \"approach\" [0, 0, 0]: that has no direction, so it is no line. "
            "Set \"approach\" to the direction in which the knot shall come");
}

}  // namespace
}  // namespace robots::test
