// These press the emergency stop. Four arms of two workstations hear of it from a coordinator at a
// desk, over each lane.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "coordinator/coordinator.h"
#include "integration/teleoperation/scene/driven_arm.h"
#include "support/pass.h"
#include "support/stepped.h"
#include "support/temporary_directory.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using suture::pass;

/// Stands for the operator.
struct OperatorPanel final : suture::Device {
  suture::Required<EmergencyStop> button{*this, "Stop"};
  suture::Required<Arm> left{*this, "Left"}, right{*this, "Right"};
};

/// The other workstation has this button.
struct DeputyPanel final : suture::Device {
  suture::Required<EmergencyStop> button{*this, "Stop"};
};

/// Runs the desk, the left and the right workstation as three processes; with Lane::Auto all are in
/// one.
class Stop : public testing::TestWithParam<suture::Lane> {
 protected:
  static constexpr suture::Duration kPermit = 30ms;
  static constexpr suture::Duration kSilence = 500ms;  // longer than a permit

  explicit Stop(const CoordinatorParameters& parameters = {}) : coordinator_(parameters) {
    desk().add("Coordinator", coordinator_);
    leftMaster_.addTo(left_, "MTML");
    leftSlave_.addTo(left_, "PSM2");
    left_.add("Panel", panel_);
    rightMaster_.addTo(right(), "MTMR");
    rightSlave_.addTo(right(), "PSM1");
    right().add("Deputy", deputy_);
    left_.start();
    if (!isOneProcess()) {
      desksProcess_.run([this] { desk_.start(); });
      rightsProcess_.run([this] { right_.start(); });
    }
    for (const char* const arm : {"MTML", "PSM2"}) connectStop(left_, arm + std::string("Drives"));
    for (const char* const arm : {"MTMR", "PSM1"})
      connectStop(right(), arm + std::string("Drives"));
    connectStop(left_, "Panel");
    connectStop(right(), "Deputy");
    left_.connect("Panel/Left", "PSM2/Arm");
    connect(left_, "Panel/Right", "right", "PSM1/Arm");
    pass(50ms);
    EXPECT_TRUE(all(DrivePower::NotReady) && allAre(ArmState::Undefined)) << "it starts pressed";
    EXPECT_TRUE(panel_.button.release(coordinator_.permit().press));
    EXPECT_TRUE(until([this] { return all(DrivePower::Off) && allAre(ArmState::Disabled); }));
  }
  ~Stop() override {
    right_.stop();
    left_.stop();
    desk_.stop();
  }

  /// Gives both slaves power, and returns when they move.
  void beginMoving() {
    EXPECT_TRUE(panel_.left.enable());
    EXPECT_TRUE(panel_.right.enable());
    EXPECT_TRUE(until([this] { return slaves(DrivePower::On); }));
    pass(5ms);
    JointGoal goal{std::vector<double>(6, 0.4), suture::now()};
    goal.position[2] = 0.1;
    EXPECT_TRUE(panel_.left.move_jp(goal));
    EXPECT_TRUE(panel_.right.move_jp(goal));
    EXPECT_TRUE(until([this] { return moves(leftSlave_) && moves(rightSlave_); }));
  }
  template <class Condition>
  static bool until(const Condition& condition) {
    return suture::clockOfTest().until(condition);
  }
  bool all(DrivePower power) { return masters(power) && slaves(power); }
  bool masters(DrivePower power) {
    return powerOf(leftMaster_) == power && powerOf(rightMaster_) == power;
  }
  bool slaves(DrivePower power) {
    return powerOf(leftSlave_) == power && powerOf(rightSlave_) == power;
  }
  void expectStoppedUntilReleased() {
    EXPECT_TRUE(all(DrivePower::Stopped));
    EXPECT_TRUE(panel_.button.release(coordinator_.permit().press));
    pass(50ms);
    EXPECT_TRUE(all(DrivePower::Off)) << "an operator has decided it";
  }
  bool allAre(ArmState state) {
    return stateOf(leftMaster_) == state && stateOf(rightMaster_) == state &&
           stateOf(leftSlave_) == state && stateOf(rightSlave_) == state;
  }
  template <class Driven>
  static DrivePower powerOf(const Driven& one) {
    return one.drives.feedback().power;
  }
  template <class Driven>
  static ArmState stateOf(const Driven& one) {
    return one.arm.operating_state().state;
  }
  static bool moves(const DrivenPsm& slave) {
    return std::abs(slave.drives.feedback().velocity[0]) > 0.05;
  }
  static bool stands(const DrivenPsm& slave) { return slave.drives.feedback().velocity[0] == 0; }

  const suture::TemporaryDirectory directory_;
  suture::TestClock::Process desksProcess_{suture::clockOfTest()};
  suture::TestClock::Process rightsProcess_{suture::clockOfTest()};
  suture::loop::ControlThread control_;
  suture::GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  Coordinator coordinator_;
  DrivenMtm leftMaster_{Side::Left, kPermit}, rightMaster_{Side::Right, kPermit};
  DrivenPsm leftSlave_{kPermit}, rightSlave_{kPermit};
  OperatorPanel panel_;
  DeputyPanel deputy_;
  suture::Manager desk_{"desk", names_.address()}, left_{"left", names_.address()},
      right_{"right", names_.address()};

  static void connectStop(suture::Manager& client, const std::string& component) {
    connect(client, component + "/Stop", "desk", "Coordinator/Stop");
  }

  static bool isOneProcess() { return GetParam() == suture::Lane::Auto; }
  suture::Manager& right() { return isOneProcess() ? left_ : right_; }

 private:
  suture::Manager& desk() { return isOneProcess() ? left_ : desk_; }
  static void connect(suture::Manager& client, const std::string& required,
                      const std::string& process, const std::string& provided) {
    if (isOneProcess()) return client.connect(required, provided);
    client.connect(required, process + ":" + provided,
                   {.lane = GetParam(), .contract = {.silence = kSilence}});
  }
};

INSTANTIATE_TEST_SUITE_P(Lanes, Stop,
                         testing::Values(suture::Lane::Auto, suture::Lane::Shm, suture::Lane::Frame,
                                         suture::Lane::Rpc),
                         [](const auto& one) { return toString(one.param); });

TEST_P(Stop, StopsAllDrivesWithinThreeMilliseconds) {
  beginMoving();
  ASSERT_TRUE(panel_.button.press());
  pass(3ms);
  EXPECT_TRUE(all(DrivePower::Stopped));
  EXPECT_TRUE(stands(leftSlave_) && stands(rightSlave_));
  pass(5ms);
  EXPECT_TRUE(allAre(ArmState::Disabled));
}

TEST_P(Stop, NeitherArmsNorReleaseUndoIt) {
  beginMoving();
  ASSERT_TRUE(panel_.button.press());
  pass(10ms);
  EXPECT_TRUE(panel_.left.enable());
  EXPECT_TRUE(panel_.right.enable());
  pass(10ms);
  EXPECT_TRUE(all(DrivePower::Stopped));
  EXPECT_TRUE(allAre(ArmState::Disabled));
  const auto released = panel_.button.release(coordinator_.permit().press);
  ASSERT_TRUE(released) << suture::toString(released.error());
  pass(100ms);
  EXPECT_TRUE(all(DrivePower::Off)) << "power is permitted, and nobody has asked for it";
  EXPECT_TRUE(allAre(ArmState::Disabled));
  beginMoving();
}

TEST_P(Stop, ABriefStopStopsTheDrives) {
  beginMoving();
  const std::uint64_t before = coordinator_.permit().press;
  ASSERT_TRUE(panel_.button.press());
  ASSERT_TRUE(until([&] { return coordinator_.permit().press != before; }));
  ASSERT_TRUE(panel_.button.release(coordinator_.permit().press));
  pass(10ms);
  EXPECT_TRUE(all(DrivePower::Off)) << "they stopped, and may have power again";
  EXPECT_TRUE(allAre(ArmState::Disabled));
}

TEST_P(Stop, StopsDrivesWhoseArmHangs) {
  beginMoving();
  left_.suspend("PSM2");
  ASSERT_TRUE(panel_.button.press());
  pass(3ms);
  EXPECT_EQ(powerOf(leftSlave_), DrivePower::Stopped);
  EXPECT_TRUE(stands(leftSlave_));
}

// The steady clock stood still with the machine, so all that is known looks as new as before.
TEST_P(Stop, StopsDrivesOfAMachineThatSlept) {
  beginMoving();
  const std::uint64_t before = coordinator_.permit().press;
  suture::clockOfTest().suspend(200ms);
  pass(2ms);
  EXPECT_TRUE(slaves(DrivePower::Off)) << "they stopped, and may have power again";
  EXPECT_TRUE(stands(leftSlave_) && stands(rightSlave_));
  EXPECT_EQ(coordinator_.permit().press, before) << "no press can have been lost";
}

TEST_P(Stop, IsPressedAfterALongSleep) {
  beginMoving();
  suture::clockOfTest().suspend(1h);
  pass(50ms);
  EXPECT_FALSE(coordinator_.permit().granted);
  pass(2s);
  expectStoppedUntilReleased();
}

/// Without the second button nobody releases the stop.
class TwoButtons : public Stop {
 protected:
  TwoButtons() : Stop({.buttons = {isOneProcess() ? "left:Deputy/Stop" : "right:Deputy/Stop"}}) {}
  void releaseByPanel() {
    EXPECT_TRUE(panel_.button.release(coordinator_.permit().press));
    pass(50ms);
  }
  bool isReleased() const { return coordinator_.permit().granted; }
};
INSTANTIATE_TEST_SUITE_P(Lanes, TwoButtons,
                         testing::Values(suture::Lane::Auto, suture::Lane::Shm, suture::Lane::Frame,
                                         suture::Lane::Rpc),
                         [](const auto& one) { return toString(one.param); });

TEST_P(TwoButtons, ReleaseKeepsANewerPress) {
  ASSERT_TRUE(deputy_.button.press());
  pass(50ms);
  const std::uint64_t heard = coordinator_.permit().press;
  ASSERT_TRUE(panel_.button.press());
  pass(10ms);
  ASSERT_TRUE(deputy_.button.release(heard));
  pass(50ms);
  EXPECT_FALSE(isReleased()) << "somebody has pressed since";
  releaseByPanel();
  EXPECT_TRUE(isReleased());
}

TEST_P(TwoButtons, ALostButtonPressesIt) {
  beginMoving();
  right().disconnect("Deputy/Stop");
  pass(50ms);
  EXPECT_TRUE(all(DrivePower::Stopped));
  releaseByPanel();
  EXPECT_FALSE(isReleased()) << "nobody could press the other one";
  connectStop(right(), "Deputy");
  pass(50ms);
  EXPECT_FALSE(isReleased());
  releaseByPanel();
  EXPECT_TRUE(isReleased());
}

TEST_P(TwoButtons, OneThatGoesEarlyKeepsItPressed) {
  coordinator_.onRestart();  // nobody has released it since it began
  pass(50ms);
  const std::uint64_t heard = coordinator_.permit().press;
  right().disconnect("Deputy/Stop");
  pass(50ms);
  EXPECT_TRUE(panel_.button.release(heard));
  pass(50ms);
  EXPECT_FALSE(isReleased()) << "it has been pressed by that since";
  releaseByPanel();
  EXPECT_FALSE(isReleased()) << "nobody could press the other one";
  connectStop(right(), "Deputy");
  pass(50ms);
  EXPECT_FALSE(isReleased()) << "an operator has to decide it";
  releaseByPanel();
  EXPECT_TRUE(isReleased());
}

/// Runs only where the arms and the coordinator are in different processes.
class StopAcross : public Stop {};
INSTANTIATE_TEST_SUITE_P(Lanes, StopAcross,
                         testing::Values(suture::Lane::Shm, suture::Lane::Frame, suture::Lane::Rpc),
                         [](const auto& one) { return toString(one.param); });

TEST_P(StopAcross, StopsDrivesWhoseCoordinatorStandsStill) {
  beginMoving();
  desksProcess_.freeze();
  pass(35ms);
  EXPECT_TRUE(all(DrivePower::Stopped));
  EXPECT_TRUE(stands(leftSlave_) && stands(rightSlave_));
  desksProcess_.thaw();
  pass(50ms);
  EXPECT_TRUE(all(DrivePower::Off)) << "nothing moves by itself";
  EXPECT_TRUE(allAre(ArmState::Disabled));
}

TEST_P(StopAcross, IsPressedAfterASuspension) {
  beginMoving();
  desksProcess_.run([this] { desk_.suspend("Coordinator"); });
  pass(50ms);
  EXPECT_FALSE(panel_.button.press()) << "it cannot take a command";
  desksProcess_.run([this] { desk_.resume("Coordinator"); });
  pass(50ms);
  expectStoppedUntilReleased();
}

TEST_P(StopAcross, IsPressedAfterALongPause) {
  beginMoving();
  desksProcess_.freeze();
  pass(1550ms);
  desksProcess_.thaw();
  pass(50ms);
  EXPECT_FALSE(coordinator_.permit().granted);
  pass(2s);
  expectStoppedUntilReleased();
}

// The connection's silence is shorter than the pause, so the press that was accepted is lost.
TEST_P(StopAcross, IsPressedWhenAPressIsLost) {
  beginMoving();
  desksProcess_.freeze();
  pass(100ms);
  ASSERT_TRUE(panel_.button.press());
  pass(500ms);
  desksProcess_.thaw();
  pass(500ms);
  EXPECT_FALSE(coordinator_.permit().granted);
  expectStoppedUntilReleased();
}

TEST_P(StopAcross, ALateClientReleasesIt) {
  left_.disconnect("Panel/Stop");
  pass(50ms);
  desksProcess_.freeze();
  pass(100ms);
  desksProcess_.thaw();
  pass(50ms);
  connectStop(left_, "Panel");
  EXPECT_TRUE(panel_.button.release(coordinator_.permit().press));
  pass(50ms);
  left_.disconnect("Panel/Stop");
  pass(50ms);
  EXPECT_TRUE(coordinator_.permit().granted);
}

// The client was new after no pause or an earlier one, and is told to have gone some cycles later.
TEST_P(StopAcross, ALatecomersLostPressPressesIt) {
  const suture::ProvidedBase& stop = *coordinator_.provided().front();
  const suture::ConnectedClient late("late:Panel/Stop", 100ms);
  coordinator_.onClient(stop, late, suture::ClientNews::Connected);
  pass(10ms);
  desksProcess_.freeze();
  pass(100ms);
  desksProcess_.thaw();
  pass(10ms);
  ASSERT_TRUE(coordinator_.permit().granted);
  coordinator_.onClient(stop, late, suture::ClientNews::Silent);
  pass(10ms);
  EXPECT_FALSE(coordinator_.permit().granted);
}

// One that was cut off is told to be silent some time after the pause, which has swallowed no press
// of it. What a client sent right before it ended may not have been executed.
TEST_P(StopAcross, OnlyALongPauseLosesAPress) {
  const suture::ProvidedBase& stop = *coordinator_.provided().front();
  const suture::ConnectedClient first("far:Panel/Stop", kSilence);
  const suture::ConnectedClient second("far:Panel/Stop", kSilence);
  coordinator_.onClient(stop, first, suture::ClientNews::Connected);
  coordinator_.onClient(stop, second, suture::ClientNews::Connected);
  pass(10ms);
  desksProcess_.freeze();
  pass(100ms);
  desksProcess_.thaw();
  pass(150ms);
  coordinator_.onClient(stop, first, suture::ClientNews::Silent);
  pass(10ms);
  EXPECT_TRUE(coordinator_.permit().granted);
  coordinator_.onClient(stop, second, suture::ClientNews::Closed);
  pass(10ms);
  EXPECT_FALSE(coordinator_.permit().granted);
}

// Its heartbeats may have come late already, so a short pause was enough.
TEST_P(StopAcross, AClientLostThenPressesIt) {
  const suture::ProvidedBase& stop = *coordinator_.provided().front();
  const suture::ConnectedClient late("far:Panel/Stop", kSilence);
  coordinator_.onClient(stop, late, suture::ClientNews::Connected);
  pass(10ms);
  desksProcess_.freeze();
  pass(60ms);
  desksProcess_.thaw();
  pass(50ms);
  ASSERT_TRUE(coordinator_.permit().granted);
  coordinator_.onClient(stop, late, suture::ClientNews::Silent);
  pass(10ms);
  EXPECT_FALSE(coordinator_.permit().granted);
}

TEST_P(StopAcross, StopsDrivesThatAreDisconnected) {
  beginMoving();
  rightsProcess_.run([this] { right_.disconnect("PSM1Drives/Stop"); });
  pass(35ms);
  EXPECT_EQ(powerOf(rightSlave_), DrivePower::Stopped);
  EXPECT_TRUE(stands(rightSlave_));
  EXPECT_EQ(powerOf(leftSlave_), DrivePower::On) << "which hear of the coordinator";
}

TEST_P(StopAcross, StopsDrivesWhoseProcessStoodStill) {
  beginMoving();
  rightsProcess_.freeze();
  pass(200ms);
  rightsProcess_.thaw();
  pass(2ms);
  EXPECT_EQ(powerOf(rightSlave_), DrivePower::Off) << "they stopped, and may have power again";
  EXPECT_TRUE(stands(rightSlave_));
  EXPECT_EQ(powerOf(leftSlave_), DrivePower::On);
}

}  // namespace
}  // namespace robots::test
