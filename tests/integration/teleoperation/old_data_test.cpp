// Teleoperation does not act on old data, and begins anew from where the slave is.

#include <gtest/gtest.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <chrono>
#include <memory>
#include <string>

#include "integration/teleoperation/scene/scripted_arm.h"
#include "support/pass.h"
#include "support/stepped.h"
#include "support/temporary_directory.h"
#include "teleop/teleop.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using suture::pass;

Eigen::Isometry3d at(double x, double angle) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation().x() = x;
  pose.rotate(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
  return pose;
}

/// The arms stand still but for what the test has them do.
struct Scene {
  Scene() {
    master.place(at(0.1, 0.2));
    slave.place(at(0.3, -0.4));
  }

  std::size_t goalsIn(suture::Duration duration) {
    slave.forgetGoals();
    pass(duration);
    return slave.goals().size();
  }
  /// Following has ended, and is to begin again: the slave stays where the test puts it now, and
  /// follows the master from there.
  template <class Resume>
  void expectNoJump(const Resume& resume) {
    master.place(at(0.5, 1.0));
    slave.place(at(-0.2, 0.7));
    slave.forgetGoals();
    resume();
    ASSERT_TRUE(suture::clockOfTest().until([&] { return !slave.goals().empty(); }));
    EXPECT_TRUE(slave.goals().front().pose.isApprox(at(-0.2, 0.7), 1e-9)) << "it jumped";
    pass(20ms);  // until it is known that the slave carries that out
    master.place(at(0.6, 1.0));
    pass(20ms);
    EXPECT_TRUE(slave.pose().isApprox(at(-0.2 + 0.5 * 0.1, 0.7), 1e-9)) << "it does not follow";
  }

  ScriptedArm master, slave;
  Teleop teleop{{.scale = 0.5, .align = false}};
};

class OldData : public testing::Test {
 protected:
  OldData() {
    manager_.add("MTM", scene_.master);
    manager_.add("PSM", scene_.slave);
    manager_.add("Teleop", scene_.teleop);
    manager_.connect("Teleop/Master", "MTM/Arm");
    manager_.connect("Teleop/Slave", "PSM/Arm");
    manager_.start();
    EXPECT_GT(scene_.goalsIn(50ms), 40u) << "it does not follow to begin with";
  }
  ~OldData() override { manager_.stop(); }

  Scene scene_;
  suture::Manager manager_{"console"};
};

TEST_F(OldData, TheMastersOldDataAreNotFollowed) {
  scene_.master.beSilent(true);
  EXPECT_LE(scene_.goalsIn(30ms), 21u) << "they are too old after 20 ms";
  EXPECT_EQ(scene_.goalsIn(100ms), 0u);
  scene_.expectNoJump([&] { scene_.master.beSilent(false); });
}

TEST_F(OldData, TheSlavesOldDataEndFollowing) {
  scene_.slave.beSilent(true);
  EXPECT_LE(scene_.goalsIn(30ms), 21u) << "they are too old after 20 ms";
  EXPECT_EQ(scene_.goalsIn(100ms), 0u);
  scene_.expectNoJump([&] { scene_.slave.beSilent(false); });
}

// The row is new, what it holds is not: the encoders of the master, or what relays it, are stuck.
TEST_F(OldData, InANewRowAreNotFollowed) {
  scene_.master.beStuck(true);
  EXPECT_LE(scene_.goalsIn(30ms), 21u) << "they are too old after 20 ms";
  EXPECT_EQ(scene_.goalsIn(100ms), 0u);
  scene_.expectNoJump([&] { scene_.master.beStuck(false); });
}

// If following went on, nothing would ever bring the two arms together again.
TEST_F(OldData, ATooFarGoalEndsFollowing) {
  scene_.slave.refuseStepsBeyond(0.05);
  scene_.expectNoJump([] {});
}

TEST_F(OldData, ANewLinkMovesNoSlave) {
  manager_.disconnect("Teleop/Slave");
  pass(5ms);
  EXPECT_EQ(scene_.goalsIn(50ms), 0u);
  scene_.expectNoJump([&] { manager_.connect("Teleop/Slave", "PSM/Arm"); });
}

TEST_F(OldData, ANewDelayedLinkMovesNoSlave) {
  manager_.disconnect("Teleop/Slave");
  pass(5ms);
  scene_.expectNoJump([&] {
    manager_.connect("Teleop/Slave", "PSM/Arm", {.delay = {.commands = 3ms, .answers = 3ms}});
  });
}

// It has not seen what happened meanwhile, and both arms' data are fresh when it looks again.
TEST_F(OldData, ATeleoperationThatWasSuspendedBeginsAnew) {
  manager_.suspend("Teleop");
  pass(50ms);
  scene_.expectNoJump([&] { manager_.resume("Teleop"); });
}

// The arms have been elsewhere meanwhile, and no stamp tells how long that was.
TEST_F(OldData, AMachineThatSleptMovesNoSlave) {
  scene_.expectNoJump([] { suture::clockOfTest().suspend(1h); });
}

/// The process of the teleoperation stands still, but not for so long that a link is lost. Both
/// arms are elsewhere.
class FrozenTeleoperation : public testing::TestWithParam<suture::Lane> {
 protected:
  FrozenTeleoperation() {
    console_.run([this] {
      manager_ = std::make_unique<suture::Manager>("console", names_.address());
      manager_->add("Teleop", scene_.teleop);
      manager_->start();
    });
    robot_ = std::make_unique<suture::Manager>("robot", names_.address());
    robot_->add("PSM", scene_.slave);
    robot_->add("MTM", scene_.master);
    robot_->start();
    console_.run([this] {
      manager_->connect("Teleop/Master", "robot:MTM/Arm", {.lane = GetParam()});
      manager_->connect("Teleop/Slave", "robot:PSM/Arm", {.lane = GetParam()});
    });
  }
  ~FrozenTeleoperation() override {
    manager_->stop();
    robot_->stop();
  }

  const suture::TemporaryDirectory directory_;
  suture::TestClock::Process console_{suture::clockOfTest()};
  suture::loop::ControlThread control_;
  suture::GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  Scene scene_;
  std::unique_ptr<suture::Manager> robot_, manager_;
};

INSTANTIATE_TEST_SUITE_P(Lanes, FrozenTeleoperation,
                         testing::Values(suture::Lane::Shm, suture::Lane::Frame, suture::Lane::Rpc),
                         [](const auto& one) { return toString(one.param); });

TEST_P(FrozenTeleoperation, BeginsAnewWithoutAJump) {
  ASSERT_TRUE(suture::clockOfTest().until([&] { return scene_.goalsIn(50ms) > 40; }));
  console_.freeze();
  pass(300ms);
  scene_.expectNoJump([&] {
    pass(5ms);  // so that the rows tell of where the arms are
    console_.thaw();
  });
}

/// The slave's process stands still for so long that the link is lost, and comes back.
class LostLink : public testing::TestWithParam<suture::Lane> {
 protected:
  LostLink() {
    robotsProcess_.run([this] {
      robot_ = std::make_unique<suture::Manager>("robot", names_.address());
      robot_->add("PSM", scene_.slave);
      robot_->start();
    });
    console_ = std::make_unique<suture::Manager>("console", names_.address());
    console_->add("MTM", scene_.master);
    console_->add("Teleop", scene_.teleop);
    console_->start();
    console_->connect("Teleop/Master", "MTM/Arm");
    console_->connect("Teleop/Slave", "robot:PSM/Arm",
                      {.lane = GetParam(), .contract = {.silence = 100ms}});
  }
  ~LostLink() override {
    console_->stop();
    robot_->stop();
  }

  const suture::TemporaryDirectory directory_;
  suture::TestClock::Process robotsProcess_{suture::clockOfTest()};
  suture::loop::ControlThread control_;
  suture::GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  Scene scene_;
  std::unique_ptr<suture::Manager> robot_, console_;
};

INSTANTIATE_TEST_SUITE_P(Lanes, LostLink,
                         testing::Values(suture::Lane::Shm, suture::Lane::Frame, suture::Lane::Rpc),
                         [](const auto& one) { return toString(one.param); });

TEST_P(LostLink, ItsReturnMovesNoSlave) {
  ASSERT_TRUE(suture::clockOfTest().until([&] { return scene_.goalsIn(50ms) > 40; }));
  robotsProcess_.freeze();
  pass(300ms);
  scene_.expectNoJump([&] { robotsProcess_.thaw(); });
}

}  // namespace
}  // namespace robots::test
