// The guide of a knot goes by what is registered: where bases, camera and display stand.

#include <gtest/gtest.h>
#include <suture/base/errors.h>

#include "integration/teleoperation/scene/guided_arms.h"
#include "support/refusal.h"

namespace robots::test {
namespace {

/// The guide goes on by where things stood, for as long as the last sighting of the knot counts.
TEST_F(Guide, GoesOnWhenTheRegistrationIsLost) {
  manager_.disconnect("Guide/Registration");
  pass(50ms);
  EXPECT_EQ(guide_.guidance_state(), GuidanceState::Guiding);
  moveMasters({0.01, 0, 0}, 100);
  pass(5ms);
  EXPECT_NEAR(left().x(), -0.04 + 0.004, 1e-6);
  pass(200ms);
  EXPECT_FALSE(guide_.progress().valid) << "the camera may be anywhere";
  EXPECT_EQ(guide_.guidance_state(), GuidanceState::Preparing);
  manager_.connect("Guide/Registration", "Registration/Registration");
  ASSERT_TRUE(becomes(GuidanceState::Guiding));
  expectThatBothFollow();
}

TEST_F(Guide, AnOldRegistrationBeginsNothing) {
  registerLate(400ms);
  pass(100ms);
  EXPECT_EQ(guide_.guidance_state(), GuidanceState::Guiding) << "it goes on";
  guide_.disable();
  pass(2ms);
  guide_.enable();
  pass(1s);
  EXPECT_EQ(guide_.guidance_state(), GuidanceState::Preparing);
  registerLate(0ms);
  ASSERT_TRUE(becomes(GuidanceState::Guiding));
  expectThatBothFollow();
}

TEST_F(Guide, AnOldRegistrationBeginsNothingAnew) {
  registerLate(400ms);
  pass(100ms);
  ASSERT_EQ(guide_.guidance_state(), GuidanceState::Guiding);
  arms_[3].warn(ArmWarning::StepTooFar);
  pass(5ms);
  EXPECT_EQ(guide_.guidance_state(), GuidanceState::Preparing);
}

TEST(Registration, RefusesFramesThatAreNotRigid) {
  SceneFrames mirrored;
  mirrored.left_base.linear()(0, 0) = -1;
  EXPECT_EQ(suture::refusal([&] { const RegistrationTable table(mirrored); }),
            "registering the frame \"left_base\": its rotation is not orthonormal to 1e-6, or "
            "mirrors. Write a rotation matrix with all its digits");
}

/// No registration says where the camera was when the picture was taken.
TEST_F(Guide, SeesNothingInUnregisteredPictures) {
  RegistrationTable moved{[] {
    SceneFrames frames;
    frames.camera.translation().x() = 0.05;
    return frames;
  }()};
  manager_.disconnect("Guide/Registration");
  manager_.add("Moved", moved);
  manager_.start();
  manager_.connect("Guide/Registration", "Moved/Registration");
  pass(20ms);
  EXPECT_TRUE(guide_.progress().valid);
  EXPECT_NEAR(guide_.progress().knot.x(), 0, 1e-9);
  pass(50ms);
  EXPECT_GT(guide_.progress().knot.x(), 0.005) << "now it was";
  manager_.stop();  // before its components are gone
}

/// The arms have not moved; only what is known of them has changed.
TEST_F(Guide, ACorrectedBaseMovesNoSlave) {
  RegistrationTable corrected{[] {
    SceneFrames frames;
    frames.left_base.translation().y() = 0.002;
    return frames;
  }()};
  manager_.add("Corrected", corrected);
  manager_.start();
  const Vector3d leftHeld = left(), rightHeld = right();
  manager_.disconnect("Guide/Registration");
  manager_.connect("Guide/Registration", "Corrected/Registration");
  forgetGoals();
  pass(100ms);
  EXPECT_EQ(guide_.guidance_state(), GuidanceState::Guiding);
  for (const std::size_t slave : {2, 3}) {
    const Vector3d& held = slave == 2 ? leftHeld : rightHeld;
    for (const PoseStamped& goal : arms_[slave].goals()) {
      EXPECT_TRUE(goal.pose.translation().isApprox(held, 1e-9)) << "it jumped";
    }
  }
  EXPECT_GT(goals(), 0u);
  expectThatBothFollow();
  manager_.stop();  // before its components are gone
}

/// A master that rests sends no goals, so its arm accepts another base.
TEST_F(Guide, ARestingMastersBaseMovesNoSlave) {
  for (const std::size_t master : {0, 1}) {
    const Vector3d leftHeld = left(), rightHeld = right();
    arms_[master].rebase({0.05, 0, 0});
    pass(100ms);
    EXPECT_TRUE(left().isApprox(leftHeld, 1e-9)) << "it jumped";
    EXPECT_TRUE(right().isApprox(rightHeld, 1e-9)) << "it jumped";
  }
  expectThatBothFollow();
}

/// Turns what stands there about `centre`, m.
void turn(Eigen::Isometry3d& frame, const Vector3d& centre, double angle, const Vector3d& axis) {
  const Eigen::Translation3d there(centre);
  frame = there * Eigen::AngleAxisd(angle, axis.normalized()) * there.inverse() * frame;
}

/// Everything is turned some other way, tips and knot about where they are: no pair of axes is the
/// same.
SceneFrames turnedScene() {
  SceneFrames frames;
  turn(frames.left_base, {-0.04, 0, -0.03}, 0.7, {1, 0.2, 0});
  turn(frames.right_base, {0.04, 0, -0.03}, -1.1, {0, 0.3, 1});
  turn(frames.camera, {0, 0, -0.05}, 0.9, {0.5, 1, 0});
  turn(frames.left_master, Vector3d::Zero(), 0.4, {0, 1, 1});
  turn(frames.right_master, Vector3d::Zero(), -0.6, {1, 1, 0});
  turn(frames.display, Vector3d::Zero(), 0.3, {1, 0, 1});
  return frames;
}

/// TurnedGuide has everything turned: what the surgeon sees at the display is still what happens in
/// the picture.
class TurnedGuide : public Guide {
 protected:
  TurnedGuide() : Guide(turnedScene()) {}

  void moveHands(const Vector3d& inDisplay) {
    const Vector3d atConsole = frames_.display.linear() * inDisplay;
    moveMaster(arms_[0], frames_.left_master.linear().transpose() * atConsole);
    moveMaster(arms_[1], frames_.right_master.linear().transpose() * atConsole);
    pass(200ms);
  }
  static void moveMaster(ScriptedArm& master, const Vector3d& by) {
    master.place(Eigen::Translation3d(by) * master.pose());
  }
  Vector3d leftInPicture() const { return frames_.camera.inverse() * frames_.left_base * left(); }
  Vector3d rightInPicture() const {
    return frames_.camera.inverse() * frames_.right_base * right();
  }
  void expectThatBothGoAsTheHands(const Vector3d& inDisplay) {
    const Vector3d leftBefore = leftInPicture(), rightBefore = rightInPicture();
    moveHands(inDisplay);
    EXPECT_LT((leftInPicture() - leftBefore - 0.4 * inDisplay).norm(), 1e-9);
    EXPECT_LT((rightInPicture() - rightBefore - 0.4 * inDisplay).norm(), 1e-9);
  }

  SceneFrames frames_ = turnedScene();
};

TEST_F(TurnedGuide, SlavesMoveAsTheHandsDo) {
  expectThatBothGoAsTheHands({0.01, 0, 0});
  expectThatBothGoAsTheHands({0, 0.01, 0});
  expectThatBothGoAsTheHands({0, 0, -0.01});
}

TEST_F(TurnedGuide, SlavesTurnAsTheHandsDo) {
  const Eigen::Matrix3d before = frames_.right_base.linear() * arms_[3].pose().linear();
  const Eigen::AngleAxisd turned(0.3, frames_.display.linear().col(2));
  const Eigen::Matrix3d base = frames_.right_master.linear();
  Eigen::Isometry3d pose = arms_[1].pose();
  pose.linear() = base.transpose() * turned * base * pose.linear();
  arms_[1].place(pose);
  pass(20ms);
  const Eigen::AngleAxisd expected(0.3, frames_.camera.linear().col(2));
  EXPECT_TRUE((frames_.right_base.linear() * arms_[3].pose().linear())
                  .isApprox(expected.toRotationMatrix() * before, 1e-9));
}

TEST_F(TurnedGuide, FollowsThePictureOfAMovedCamera) {
  expectThatBothGoAsTheHands({0.01, 0, 0});
  turn(frames_.camera, {0, 0, -0.05}, 0.8, {0, 0.2, 1});
  const Vector3d leftHeld = left(), rightHeld = right();
  registration_.set_camera(frames_.camera);
  pass(50ms);
  EXPECT_TRUE(left().isApprox(leftHeld, 1e-9)) << "the camera moved, no arm";
  EXPECT_TRUE(right().isApprox(rightHeld, 1e-9)) << "the camera moved, no arm";
  expectThatBothGoAsTheHands({0.01, 0, 0});
  EXPECT_EQ(guide_.guidance_state(), GuidanceState::Guiding);
}

TEST(RegistrationTable, RefusesARotationThatIsNone) {
  SceneFrames frames;
  frames.camera.linear() << 0.7, -0.7, 0, 0.7, 0.7, 0, 0, 0, 1;
  try {
    RegistrationTable table(frames);
    FAIL() << "it was taken";
  } catch (const suture::SetupError& error) {
    EXPECT_NE(std::string(error.what()).find("camera"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace robots::test
