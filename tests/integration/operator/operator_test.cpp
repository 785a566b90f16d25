// The operator reduces the error that is in the picture, and holds without a picture.

#include "surgeon/operator.h"

#include <gtest/gtest.h>

#include <chrono>

#include "integration/operator/desk.h"
#include "support/stepped.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using Eigen::Vector3d;
using suture::pass;

const Vector3d kTarget{0.004, -0.01, 0.02};

OperatorParameters quiet() { return {.target = kTarget, .remnant = 0, .tremor = 0}; }

struct AtDesk : testing::Test {
  Vector3d leftHand() const { return desk.left.pose().translation(); }
  Vector3d rightHand() const { return desk.right.pose().translation(); }
  double error() const { return (desk.knot() - kTarget).norm(); }

  Desk desk;
};

TEST_F(AtDesk, BringsTheKnotToItsTarget) {
  desk.seatOperator(quiet());
  pass(150ms);
  EXPECT_EQ(desk.knot(), Vector3d::Zero()) << "no operator is so quick";
  pass(5s);
  EXPECT_LT(error(), 1e-4);
  EXPECT_LT((leftHand() - rightHand()).norm(), 1e-6);
}

/// The guide lets slaves go in the picture as hands do at the display, however things are turned.
TEST(AtATurnedDesk, BringsTheKnotToItsTarget) {
  SceneFrames frames;
  frames.camera.linear() = Eigen::AngleAxisd(2, Vector3d(1, 2, 0).normalized()).matrix();
  frames.left_master.linear() = Eigen::AngleAxisd(-1, Vector3d(0, 1, 1).normalized()).matrix();
  frames.right_master.linear() = frames.left_master.linear();
  frames.display.linear() = frames.left_master.linear();  // so scene.h shows what a camera sees
  Desk desk(frames);
  desk.seatOperator(quiet());
  pass(5s);
  EXPECT_LT((frames.camera * desk.knot() - kTarget).norm(), 1e-4);
}

TEST_F(AtDesk, IsPreciseDespiteNoiseAndTremor) {
  OperatorParameters parameters = quiet();
  parameters.remnant = OperatorParameters{}.remnant;
  parameters.tremor = OperatorParameters{}.tremor;
  desk.seatOperator(parameters);
  pass(5s);
  for (int i = 0; i < 100; ++i) {
    EXPECT_LT(error(), 1e-3);
    pass(10ms);
  }
  EXPECT_GT((leftHand() - rightHand()).norm(), 1e-6) << "each hand has its own tremor";
}

TEST_F(AtDesk, MovesNoHandFasterThanBounded) {
  OperatorParameters parameters = quiet();
  parameters.target = {0, 0, 0.2};
  parameters.speed = 0.05;
  desk.seatOperator(parameters);
  pass(1s);
  Vector3d before = leftHand();
  for (int i = 0; i < 1000; ++i, before = leftHand()) {
    pass(1ms);
    ASSERT_LT((leftHand() - before).norm(), 2 * 0.05 * 0.001 * 1.01);
  }
  EXPECT_NEAR((leftHand() - Vector3d::Zero()).norm(), 0.05 * 1.7, 0.01);
}

/// The operator has a long way to go, and is on it.
struct OnTheWay : AtDesk {
  void begin(suture::Duration pictureAge) {
    OperatorParameters parameters = quiet();
    parameters.target = kFar;
    parameters.picture_age = pictureAge;
    desk.seatOperator(parameters);
    pass(500ms);
  }
  /// Expects rest once the operator's delay has passed: what the picture shows, or that it shows
  /// nothing, counts only then.
  void expectRest() {
    pass(1s);
    const Vector3d held = leftHand();
    EXPECT_GT(held.norm(), 0.05) << "it had not begun to move";
    desk.left.forgetGoals();
    pass(500ms);
    EXPECT_LT((leftHand() - held).norm(), 1e-5);
    EXPECT_GT(desk.left.goals().size(), 400u) << "it let the master go";
    EXPECT_GT((desk.knot() - kFar).norm(), 0.05) << "there was nothing left to do";
  }
  void expectArrival() {
    pass(6s);
    EXPECT_LT((desk.knot() - kFar).norm(), 1e-3);
  }

  static inline const Vector3d kFar{0.04, -0.1, 0.2};
};

TEST_F(OnTheWay, HoldsWhileTheKnotIsUnseen) {
  begin(1s);
  desk.scene.covered = true;
  expectRest();
  desk.scene.covered = false;
  expectArrival();
}

TEST_F(OnTheWay, HoldsWhileThePictureIsOld) {
  begin(200ms);
  desk.scene.frozen = true;
  expectRest();
  desk.scene.frozen = false;
  expectArrival();
}

/// A registration that comes late does not tell where the camera stood.
TEST_F(OnTheWay, HoldsWhileTheCamerasPlaceIsUnknown) {
  begin(200ms);
  desk.registerLate(400ms);
  expectRest();
  desk.registerLate(0ms);
  expectArrival();
}

TEST_F(OnTheWay, HoldsWhileNoPictureIsConnected) {
  begin(1s);
  desk.manager.disconnect("Operator/Vision");
  expectRest();
}

TEST_F(AtDesk, LetsGoWithoutAGuide) {
  desk.seatOperator(quiet());
  pass(500ms);
  desk.manager.disconnect("Operator/Guidance");
  pass(10ms);
  desk.left.forgetGoals();
  pass(100ms);
  EXPECT_TRUE(desk.left.goals().empty());
}

TEST_F(AtDesk, BeginsAnewWhereAMasterRefuses) {
  desk.seatOperator(quiet());
  pass(500ms);
  desk.right.refuseStepsBeyond(0.005);
  desk.right.place(Eigen::Translation3d(0.05, 0, 0) * desk.right.pose());
  const Vector3d moved = rightHand();
  desk.right.forgetGoals();
  pass(10ms);
  EXPECT_LT((rightHand() - moved).norm(), 1e-3) << "it leapt";
  EXPECT_FALSE(desk.right.goals().empty()) << "its goals are still refused";
  pass(5s);
  EXPECT_LT(error(), 1e-4);
}

TEST_F(AtDesk, BeginsAnewAfterItWasSuspended) {
  desk.seatOperator(quiet());
  pass(500ms);
  desk.manager.suspend("Operator");
  pass(300ms);
  desk.left.place(Eigen::Translation3d(0.05, 0, 0) * desk.left.pose());
  const Vector3d moved = leftHand();
  desk.manager.resume("Operator");
  pass(10ms);
  EXPECT_LT((leftHand() - moved).norm(), 1e-3) << "it leapt";
}

}  // namespace
}  // namespace robots::test
