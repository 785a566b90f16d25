// The guide of a knot does not act on what is old or unseen, and knows where the slaves really are.

#include <gtest/gtest.h>
#include <suture/base/errors.h>
#include <suture/component/device.h>
#include <suture/manager/manager.h>
#include <suture/standard/messages.suture.h>

#include <array>
#include <chrono>
#include <string>

#include "guidance/knot_guide.h"
#include "integration/teleoperation/scripted_arm.h"
#include "integration/teleoperation/test_console.h"
#include "registration/registration_table.h"
#include "support/pass.h"
#include "support/stepped.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using Eigen::Vector3d;
using suture::pass;

// What the guide sends is at most so far from where a slave is: of data as old as allowed.
constexpr double kMostAstray = 0.004;  // m

/// Sees the knot where it hung at the beginning, unless it is covered. An image takes 30 ms.
struct Eyes final : suture::Device, KnotVision {
  Eyes() { seen_.knot.z() = -0.05; }
  const KnotSighting& sighting() const override {
    seen_.valid = !covered;
    if (!covered) seen_.stamp = suture::now() - 30ms;
    return seen_;
  }

  bool covered = false;
  mutable KnotSighting seen_;
  suture::Provided<KnotVision> vision{*this, "Vision", *this};
};

/// Counts what the guide says of its state, and keeps the last of it.
struct Listener final : suture::Device {
  Listener() {
    guidance.on().guidance_state([this](const GuidanceState& news) {
      ++heard;
      state = news;
    });
  }
  suture::Required<Guidance> guidance{*this, "Guidance"};
  unsigned heard = 0;
  GuidanceState state = GuidanceState::Disabled;
};

Eigen::Isometry3d at(const Vector3d& place) {
  return Eigen::Isometry3d(Eigen::Translation3d(place));
}

/// Keeps what the guide complained of last.
struct Complaints final : suture::Device {
  Complaints() {
    messages.on().error([this](const suture::Message& message) { error = message.text; });
  }
  suture::Required<suture::Messages> messages{*this, "Messages"};
  std::string error;
};

class Guide : public testing::Test {
 protected:
  explicit Guide(const SceneFrames& frames = {}) : registration_(frames) {
    for (std::size_t i = 0; i < arms_.size(); ++i) {
      const bool isLeft = i % 2 == 0;
      arms_[i].place(at({isLeft ? -0.04 : 0.04, 0, -0.03}));
      manager_.add(kNames[i], arms_[i]);
      manager_.connect("Guide/" + kNames[i], kNames[i] + "/Arm");
    }
    manager_.connect("Guide/Vision", "Eyes/Vision");
    manager_.connect("Listener/Guidance", "Guide/Guidance");
    manager_.connect("Complaints/Messages", "Guide/Messages");
    manager_.connect("Guide/Registration", "Registration/Registration");
    manager_.start();
    EXPECT_TRUE(becomes(GuidanceState::Guiding));
    pass(10ms);
  }
  ~Guide() override { manager_.stop(); }

  bool becomes(GuidanceState state) {
    return suture::clockOfTest().until([&] { return guide_.guidance_state() == state; });
  }
  /// Both masters move by so much within the time.
  void moveMasters(const Vector3d& by, int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      for (ScriptedArm* master : {&arms_[0], &arms_[1]}) {
        master->place(Eigen::Translation3d(by / milliseconds) * master->pose());
      }
      pass(1ms);
    }
  }
  Vector3d left() const { return arms_[2].pose().translation(); }
  Vector3d right() const { return arms_[3].pose().translation(); }
  /// What the registration tells takes so much longer from now on.
  void registerLate(suture::Duration delay) {
    manager_.disconnect("Guide/Registration");
    manager_.connect("Guide/Registration", "Registration/Registration", suture::Lane::Auto,
                     suture::Manager::kDefaultPatience, {.answers = delay});
  }
  void forgetGoals() {
    arms_[2].forgetGoals();
    arms_[3].forgetGoals();
  }
  std::size_t goals() const { return arms_[2].goals().size() + arms_[3].goals().size(); }
  void expectThatBothFollow() {
    const Vector3d leftBefore = left(), rightBefore = right();
    moveMasters({0.01, 0, 0}, 200);
    pass(5ms);
    EXPECT_NEAR((left() - leftBefore).x(), 0.004, 1e-6);
    EXPECT_NEAR((right() - rightBefore).x(), 0.004, 1e-6);
  }

  static inline const std::array<std::string, 4> kNames{"LeftMaster", "RightMaster", "LeftSlave",
                                                        "RightSlave"};
  suture::Manager manager_{"console"};
  std::array<ScriptedArm, 4> arms_;
  Eyes eyes_;
  RegistrationTable registration_;
  KnotGuide guide_{GuideParameters{}};
  Listener listener_;
  Complaints complaints_;
  TestConsole console_;

 private:
  // Before the constructor's body, which connects them.
  const bool added_ = [this] {
    manager_.add("Eyes", eyes_);
    manager_.add("Registration", registration_);
    manager_.add("Guide", guide_);
    manager_.add("Listener", listener_);
    manager_.add("Complaints", complaints_);
    manager_.add("Console", console_);
    return true;
  }();
};

TEST_F(Guide, HasBothSlavesFollowTheirMasters) { expectThatBothFollow(); }

TEST_F(Guide, HoldsBothSlavesWhileTheDataOfAnyArmAreOld) {
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

TEST_F(Guide, HoldsBothSlavesWhileNobodySeesTheKnotThoughTheMastersMove) {
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

TEST_F(Guide, BeginsAnewFromWhereASlaveIsThatRefusesItsGoals) {
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
      << "an image of before was matched with tips that had moved since";
  expectThatBothFollow();
}

TEST_F(Guide, DoesNotSayThatItGuidesWhileItIsSuspended) {
  manager_.suspend("Guide");
  EXPECT_TRUE(becomes(GuidanceState::Preparing));
  EXPECT_FALSE(guide_.progress().valid);
  pass(20ms);
  listener_.processEvents();
  EXPECT_EQ(listener_.state, GuidanceState::Preparing);
  manager_.resume("Guide");
  EXPECT_TRUE(becomes(GuidanceState::Guiding));
}

/// Its reads go on while its commands wait for the operator.
TEST_F(Guide, DoesNotSayThatItGuidesASlaveThatTakesNoGoals) {
  manager_.disconnect("Guide/RightSlave");
  manager_.connect("Guide/RightSlave", "RightSlave/Arm", suture::Lane::Auto,
                   suture::Manager::kDefaultPatience, {},
                   {.maxAge = 20ms, .resume = suture::Resume::Operator});
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

/// Else it would catch up at once, by a way that no fixture has looked at, when the limit ends.
TEST_F(Guide, SendsASlaveThatSlidesAlongALimitNotFarFromWhereItIs) {
  arms_[2].stayAbove(-0.031);
  forgetGoals();
  moveMasters({0, 0, -0.1}, 1000);
  for (const PoseStamped& goal : arms_[2].goals()) {
    ASSERT_GT(goal.pose.translation().z(), -0.031 - kMostAstray);
  }
  EXPECT_GT(goals(), 1000u) << "the other one would follow no more";
}

/// Where things stood is good enough to go on, until nobody has seen the knot from a camera that is
/// registered.
TEST_F(Guide, GoesOnByALostRegistrationAsLongAsTheKnotCounts) {
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

TEST_F(Guide, DoesNotBeginByARegistrationThatIsOld) {
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

TEST_F(Guide, DoesNotBeginAnewByARegistrationThatIsOld) {
  registerLate(400ms);
  pass(100ms);
  ASSERT_EQ(guide_.guidance_state(), GuidanceState::Guiding);
  arms_[3].warn(ArmWarning::StepTooFar);
  pass(5ms);
  EXPECT_EQ(guide_.guidance_state(), GuidanceState::Preparing);
}

/// Nobody has registered where the camera was when the picture was taken.
TEST_F(Guide, SeesNothingInPicturesFromBeforeTheRegistration) {
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
  manager_.stop();  // before what it runs is gone
}

// No goal leads there while its tool is not in, so nobody may believe that it is guided.
TEST_F(Guide, IsDisabledByASlaveThatRefusesItsGoalsAndSaysWhy) {
  for (ScriptedArm* slave : {&arms_[2], &arms_[3]}) {
    slave->warn(ArmWarning::NotInserted);
    ASSERT_TRUE(becomes(GuidanceState::Disabled));
    pass(2ms);
    ASSERT_TRUE(complaints_.processEvents());
    EXPECT_NE(complaints_.error.find("refuses its goals"), std::string::npos) << complaints_.error;
    complaints_.error.clear();
    forgetGoals();
    moveMasters({0, 0, 0.02}, 50);
    EXPECT_EQ(goals(), 0u);
    guide_.enable();
    ASSERT_TRUE(becomes(GuidanceState::Guiding));
    expectThatBothFollow();
  }
}

/// The surgeon has pedals, and a viewer that tells of presence.
class GuideWithPedals : public Guide {
 protected:
  GuideWithPedals() {
    manager_.connect("Guide/Pedals", "Console/Pedals");
    manager_.connect("Guide/Presence", "Console/Presence");
    pass(10ms);
    EXPECT_TRUE(becomes(GuidanceState::Guiding));
  }

  /// Both slaves hold, and the masters move without them, until `resume()`; then they follow from
  /// where they are.
  template <class Resume>
  void expectThatBothHoldUntil(const Resume& resume) {
    ASSERT_TRUE(becomes(GuidanceState::Clutched));
    pass(2ms);
    forgetGoals();
    const Vector3d leftHeld = left(), rightHeld = right();
    moveMasters({0.03, 0.02, 0}, 50);
    EXPECT_EQ(goals(), 0u);
    resume();
    ASSERT_TRUE(becomes(GuidanceState::Guiding));
    pass(5ms);
    EXPECT_GT(goals(), 0u);
    EXPECT_TRUE(left().isApprox(leftHeld, 1e-9)) << "it jumped";
    EXPECT_TRUE(right().isApprox(rightHeld, 1e-9)) << "it jumped";
    expectThatBothFollow();
  }
};

TEST_F(GuideWithPedals, HoldsBothSlavesWhileTheClutchIsPressed) {
  console_.clutch = true;
  expectThatBothHoldUntil([&] { console_.clutch = false; });
}

TEST_F(GuideWithPedals, HoldsBothSlavesWhileNobodyIsThere) {
  console_.present = false;
  expectThatBothHoldUntil([&] { console_.present = true; });
}

TEST_F(GuideWithPedals, HoldsBothSlavesWhilePedalsAreSilent) {
  console_.stuck = true;
  expectThatBothHoldUntil([&] { console_.stuck = false; });
}

/// The knot is not lost meanwhile: nobody but the tips moves it.
TEST_F(GuideWithPedals, KnowsWhereTheKnotIsWhileTheClutchIsPressed) {
  console_.clutch = true;
  ASSERT_TRUE(becomes(GuidanceState::Clutched));
  pass(100ms);
  EXPECT_TRUE(guide_.progress().valid);
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

/// What the surgeon sees at the display is what happens in the picture.
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

TEST_F(TurnedGuide, HasBothSlavesMoveInThePictureAsTheHandsAtTheDisplay) {
  expectThatBothGoAsTheHands({0.01, 0, 0});
  expectThatBothGoAsTheHands({0, 0.01, 0});
  expectThatBothGoAsTheHands({0, 0, -0.01});
}

TEST_F(TurnedGuide, TurnsBothSlavesInThePictureAsTheHandsAtTheDisplay) {
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

TEST_F(TurnedGuide, FollowsInThePictureOfACameraThatWasMovedMeanwhile) {
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

TEST(KnotGuide, RefusesAScaleAndALineThatNobodyCanFollow) {
  EXPECT_THROW(KnotGuide({.scale = -1}), suture::SetupError);
  EXPECT_THROW(KnotGuide({.approach = {0, 0, 0}}), suture::SetupError);
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
