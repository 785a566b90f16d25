// These are the states of a teleoperation: alignment, clutch and presence, locks, scale and view.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/manager/manager.h>
#include <suture/standard/messages.suture.h>

#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "integration/teleoperation/scene/scripted_arm.h"
#include "integration/teleoperation/scene/test_console.h"
#include "registration/registration_table.h"
#include "support/pass.h"
#include "support/stepped.h"
#include "teleop/teleop.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using suture::pass;

Isometry3d at(const Vector3d& position, double angle) {
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() = position;
  pose.rotate(Eigen::AngleAxisd(angle, Vector3d::UnitZ()));
  return pose;
}

/// Sets the teleoperation as an operator does, and keeps what it tells.
class Operator final : public suture::Device {
 public:
  Operator() {
    teleop.on().teleop_state([this](const TeleopState& state) { states.push_back(state); });
    messages.on().error([this](const suture::Message& message) { error = message.text; });
  }

  /// Returns the states as far as they have been told by now.
  std::vector<TeleopState> told() {
    EXPECT_TRUE(processEvents());
    return states;
  }
  TeleopState state() { return told().empty() ? TeleopState::Disabled : states.back(); }

  suture::Required<Teleoperation> teleop{*this, "Teleoperation"};
  suture::Required<suture::Messages> messages{*this, "Messages"};
  suture::Required<Registration> registration{*this, "Registration"};
  std::vector<TeleopState> states;
  std::string error;
};

/// The arms stand still but for what the test has them do.
class TeleopStates : public testing::Test {
 protected:
  TeleopStates() {
    master_.place(at({0.1, 0, 0}, 0.2));
    slave_.place(at({0.3, 0, 0}, -0.4));
  }
  ~TeleopStates() override { manager_.stop(); }

  /// The teleoperation's required interface `name` is connected only when the test says so.
  void leaveForLater(const std::string& name) { later_ = name; }
  void connectWhatWasLeft() { connect(later_); }

  void start(const TeleopParameters& parameters = {.scale = 0.5}) {
    teleop_ = std::make_unique<Teleop>(parameters);
    teleop_->restartAfterFaults({.most = 1, .per = 24h});
    manager_.add("MTM", master_);
    manager_.add("PSM", slave_);
    manager_.add("Console", console_);
    manager_.add("Registration", registration_);
    manager_.add("Teleop", *teleop_);
    manager_.add("Operator", operator_);
    manager_.connect("Operator/Teleoperation", "Teleop/Teleoperation");
    manager_.connect("Operator/Messages", "Teleop/Messages");
    manager_.connect("Operator/Registration", "Registration/Registration");
    for (suture::RequiredBase* const required : teleop_->required()) {
      if (required->name() == later_) required->expectConnection();
    }
    for (const char* const name : {"Registration", "Pedals", "Presence"}) {
      if (name != later_) connect(name);
    }
    manager_.connect("Teleop/Master", "MTM/Arm");
    manager_.connect("Teleop/Slave", "PSM/Arm");
    manager_.start();
  }
  bool reaches(TeleopState state) {
    return suture::clockOfTest().until([&] { return operator_.state() == state; });
  }
  void startFollowing() {
    start();
    ASSERT_TRUE(reaches(TeleopState::Following));
    pass(5ms);
  }
  /// Returns the way of the slave while the master goes so far, in the base frames of each.
  Vector3d wayOfSlave(const Vector3d& wayOfMaster) {
    const Vector3d before = slave_.pose().translation();
    Isometry3d pose = master_.pose();
    pose.translation() += wayOfMaster;
    master_.place(pose);
    pass(10ms);
    return slave_.pose().translation() - before;
  }
  /// Makes what the registration tells take so much longer from now on.
  void registerLate(suture::Duration delay) {
    manager_.disconnect("Teleop/Registration");
    manager_.connect("Teleop/Registration", "Registration/Registration",
                     {.delay = {.answers = delay}});
  }
  void turnMaster(double angle) {
    master_.place(master_.pose() * Eigen::AngleAxisd(angle, Vector3d::UnitZ()));
    pass(10ms);
  }
  /// The slave holds, and the master moves without it, until `resume()`; then it follows from
  /// where it is.
  template <class Resume>
  void expectClutchedUntil(const Resume& resume) {
    ASSERT_TRUE(reaches(TeleopState::Clutched));
    pass(5ms);
    EXPECT_EQ(slave_.holds(), 1u);
    EXPECT_EQ(wayOfSlave({0.2, 0.1, 0}), Vector3d::Zero());
    resume();
    ASSERT_TRUE(reaches(TeleopState::Following));
    pass(5ms);
    EXPECT_TRUE(slave_.pose().isApprox(at({0.3, 0, 0}, -0.4), 1e-9)) << "it jumped";
    EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0.05, 0, 0), 1e-9));
  }

  ScriptedArm master_, slave_;
  TestConsole console_;
  RegistrationTable registration_{SceneFrames{}};  // as all are one, the surgeon sees what is there
  std::unique_ptr<Teleop> teleop_;
  Operator operator_;
  suture::Manager manager_{"console"};

 private:
  void connect(const std::string& name) {
    const bool isRegistered = name == "Registration";
    manager_.connect("Teleop/" + name, (isRegistered ? "Registration/" : "Console/") + name);
  }

  std::string later_;
};

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

TEST_F(TeleopStates, TheMasterIsAlignedBeforeTheSlaveFollows) {
  startFollowing();
  using enum TeleopState;
  const std::vector<TeleopState> told = operator_.told();
  ASSERT_GE(told.size(), 3u);
  EXPECT_EQ(std::vector(told.end() - 2, told.end()), (std::vector{Aligning, Following}));
  EXPECT_EQ(master_.moves(), 1u);
  EXPECT_TRUE(master_.pose().isApprox(at({0.1, 0, 0}, -0.4), 1e-9)) << "it turns about its tip";
  EXPECT_TRUE(slave_.pose().isApprox(at({0.3, 0, 0}, -0.4), 1e-9)) << "only the master is moved";
  turnMaster(0.3);
  EXPECT_TRUE(slave_.pose().isApprox(at({0.3, 0, 0}, -0.1), 1e-9));
}

TEST_F(TeleopStates, ASmallDifferenceOfOrientationStays) {
  master_.place(at({0.1, 0, 0}, -0.45));
  startFollowing();
  EXPECT_EQ(master_.moves(), 0u);
  EXPECT_TRUE(slave_.pose().isApprox(at({0.3, 0, 0}, -0.4), 1e-9));
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
  EXPECT_EQ(slave_.goals().size(), 0u);
  EXPECT_EQ(master_.holds(), 1u) << "it may still be on its way";
}

TEST_F(TeleopStates, ArmsThatDoNotBecomeReadyDisableInTime) {
  slave_.beSilent(true);
  start({.preparation_limit = 5s});
  ASSERT_TRUE(reaches(TeleopState::Preparing));
  ASSERT_TRUE(reaches(TeleopState::Disabled));
  EXPECT_NE(operator_.error.find("not become ready"), std::string::npos) << operator_.error;
}

TEST_F(TeleopStates, AnOperatorWhoEnablesItAgainGivesItMoreTime) {
  slave_.beSilent(true);
  start({.preparation_limit = 5s});
  ASSERT_TRUE(reaches(TeleopState::Preparing));
  pass(4s);
  ASSERT_TRUE(operator_.teleop.enable());
  pass(4s);
  EXPECT_EQ(operator_.state(), TeleopState::Preparing) << operator_.error;
  EXPECT_TRUE(reaches(TeleopState::Disabled));
}

TEST_F(TeleopStates, TheClutchLeavesTheSlaveWhereItIs) {
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

TEST_F(TeleopStates, AMasterOfTheFutureIsNotFollowed) {
  startFollowing();
  master_.stampAhead(1s);
  ASSERT_TRUE(reaches(TeleopState::Preparing));
  pass(5ms);
  EXPECT_EQ(wayOfSlave({0.1, 0, 0}), Vector3d::Zero());
  master_.stampAhead(0s);
  EXPECT_TRUE(reaches(TeleopState::Following));
}

TEST_F(TeleopStates, AMasterTurnedWithTheClutchIsAlignedAnew) {
  startFollowing();
  console_.clutch = true;
  ASSERT_TRUE(reaches(TeleopState::Clutched));
  turnMaster(1.0);
  EXPECT_EQ(master_.moves(), 1u);
  console_.clutch = false;
  ASSERT_TRUE(reaches(TeleopState::Following));
  EXPECT_EQ(master_.moves(), 2u);
  EXPECT_TRUE(master_.pose().linear().isApprox(slave_.pose().linear(), 1e-9));
  EXPECT_TRUE(slave_.pose().isApprox(at({0.3, 0, 0}, -0.4), 1e-9));
}

TEST_F(TeleopStates, AnotherScaleDoesNotMoveTheSlave) {
  startFollowing();
  EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0.05, 0, 0), 1e-9));
  ASSERT_TRUE(operator_.teleop.set_scale(2));
  pass(5ms);
  EXPECT_TRUE(slave_.pose().isApprox(at({0.35, 0, 0}, -0.4), 1e-9)) << "it jumped";
  EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0.2, 0, 0), 1e-9));
  EXPECT_EQ(operator_.state(), TeleopState::Following);
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
  EXPECT_TRUE(slave_.pose().isApprox(at({0.3, 0, 0}, -0.1), 1e-9)) << "it still turns";
  ASSERT_TRUE(operator_.teleop.lock_translation(false));
  pass(5ms);
  EXPECT_TRUE(slave_.pose().isApprox(at({0.3, 0, 0}, -0.1), 1e-9)) << "it jumped";
  EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0.05, 0, 0), 1e-9));
}

TEST_F(TeleopStates, UnlockingTheOrientationAlignsTheMaster) {
  startFollowing();
  ASSERT_TRUE(operator_.teleop.lock_rotation(true));
  pass(5ms);
  turnMaster(0.7);
  EXPECT_TRUE(slave_.pose().isApprox(at({0.3, 0, 0}, -0.4), 1e-9));
  EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0.05, 0, 0), 1e-9)) << "it still moves";
  EXPECT_EQ(master_.moves(), 1u);
  ASSERT_TRUE(operator_.teleop.lock_rotation(false));
  pass(20ms);
  EXPECT_EQ(operator_.state(), TeleopState::Following);
  EXPECT_EQ(master_.moves(), 2u);
  EXPECT_TRUE(master_.pose().linear().isApprox(slave_.pose().linear(), 1e-9));
  EXPECT_TRUE(slave_.pose().isApprox(at({0.35, 0, 0}, -0.4), 1e-9));
}

// The camera stands on its side: what goes to the right at the console goes upward in the scene.
TEST_F(TeleopStates, DirectionsAreThoseThatTheSurgeonSees) {
  startFollowing();
  ASSERT_TRUE(operator_.registration.set_camera(at({0, 0, 0.1}, EIGEN_PI / 2)));
  pass(50ms);
  EXPECT_TRUE(slave_.pose().isApprox(at({0.3, 0, 0}, -0.4), 1e-9)) << "the camera moved, no arm";
  EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0, 0.05, 0), 1e-9));
  turnMaster(0.2);
  EXPECT_TRUE(slave_.pose().isApprox(at({0.3, 0.05, 0}, -0.2), 1e-9)) << "about the line of sight";

  console_.clutch = true;
  ASSERT_TRUE(reaches(TeleopState::Clutched));
  console_.clutch = false;
  ASSERT_TRUE(reaches(TeleopState::Following));
  const Isometry3d seen = at(Vector3d::Zero(), -EIGEN_PI / 2) * slave_.pose();
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

TEST_F(TeleopStates, ARotationOfSixDigitsIsMadeExact) {
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
TEST_F(TeleopStates, AnotherClientsRefusedCommandDoesNotDisableIt) {
  startFollowing();
  slave_.warn(ArmWarning::Malformed);
  pass(50ms);
  EXPECT_EQ(operator_.state(), TeleopState::Following);
}

TEST_F(TeleopStates, AMasterThatTellsNoRigidPoseIsNotFollowed) {
  startFollowing();
  Isometry3d bent = master_.pose();
  bent.linear()(0, 1) += 1e-3;
  master_.place(bent);
  ASSERT_TRUE(reaches(TeleopState::Preparing));
}

TEST_F(TeleopStates, ASuspendStopsATurningMaster) {
  master_.refuseMoves(true);
  start();
  ASSERT_TRUE(reaches(TeleopState::Aligning));
  manager_.suspend("Teleop");
  EXPECT_TRUE(suture::clockOfTest().until([&] { return master_.holds() == 1; }));
}

TEST_F(TeleopStates, ASuspendStopsAnArmOnItsWayHome) {
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

TEST_F(TeleopStates, WhoDisablesItStopsAnArmOnItsWayHome) {
  master_.forgetHome();
  start();
  ASSERT_TRUE(suture::clockOfTest().until([&] { return master_.homes() == 1; }));
  pass(50ms);
  ASSERT_TRUE(operator_.teleop.disable());
  EXPECT_TRUE(suture::clockOfTest().until([&] { return master_.holds() == 1; }));
  pass(50ms);
  EXPECT_EQ(master_.homes(), 1u);
}

TEST_F(TeleopStates, WhoDisablesItLeavesAnArmAloneThatSomebodyElseHomes) {
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

/// Nobody knows yet why it faulted, so it must not go on by itself.
TEST_F(TeleopStates, AFaultStopsTheSlaveAndDisablesIt) {
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

TEST_F(TeleopStates, AFaultStopsATurningMaster) {
  master_.refuseMoves(true);
  start();
  ASSERT_TRUE(reaches(TeleopState::Aligning));
  teleop_->parkSoonOnThrow([] { throw std::runtime_error("a bad number"); });
  EXPECT_TRUE(suture::clockOfTest().until([&] { return master_.holds() == 1; }));
}

TEST_F(TeleopStates, ARestDoesNotCountAsPreparation) {
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

TEST_F(TeleopStates, ASmallTurnDoesNotEndFollowing) {
  startFollowing();
  ASSERT_TRUE(operator_.teleop.lock_rotation(true));
  pass(5ms);
  turnMaster(0.05);
  ASSERT_TRUE(operator_.teleop.lock_rotation(false));
  pass(5ms);
  EXPECT_EQ(master_.moves(), 1u);
  EXPECT_EQ(operator_.state(), TeleopState::Following);
  EXPECT_TRUE(slave_.pose().isApprox(at({0.3, 0, 0}, -0.4), 1e-9)) << "it jumped";
}

TEST_F(TeleopStates, ARotationThatIsNoneIsNotRegistered) {
  startFollowing();
  Isometry3d mirrored = Isometry3d::Identity();
  mirrored.linear().col(0) *= -1;
  ASSERT_TRUE(operator_.registration.set_camera(mirrored));
  pass(50ms);
  EXPECT_TRUE(wayOfSlave({0.1, 0, 0}).isApprox(Vector3d(0.05, 0, 0), 1e-9));
}

}  // namespace
}  // namespace robots::test
