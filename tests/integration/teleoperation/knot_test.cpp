// Two masters place a knot with two slaves, by what cameras see: in one process and in three, over
// each lane.

#include <gtest/gtest.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>

#include "guidance/knot_guide.h"
#include "integration/teleoperation/scene/driven_arm.h"
#include "integration/teleoperation/scene/knot_scene.h"
#include "recorder/knot_judge.h"
#include "recorder/knot_recorder.h"
#include "registration/registration_table.h"
#include "strand/strand_simulation.h"
#include "support/pass.h"
#include "support/stepped.h"
#include "support/temporary_directory.h"
#include "surgeon/knot_surgeon.h"
#include "vision/knot_tracker.h"
#include "vision/synthetic_endoscope.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using Eigen::Vector3d;

/// The left workstation has the surgeon and the guide, the right one the other pair of arms, the
/// third one the strand and the cameras. On Lane::Auto all three are one process.
class Knot : public testing::TestWithParam<suture::Lane> {
 protected:
  ~Knot() override { stop(); }

  void begin(const GuideParameters& parameters) {
    guide_ = std::make_unique<KnotGuide>(parameters);
    leftMaster_.addTo(left_, "MTML");
    leftSlave_.addTo(left_, "PSM2");
    left_.add("Surgeon", surgeon_);
    left_.add("Guide", *guide_);
    rightMaster_.addTo(right(), "MTMR");
    rightSlave_.addTo(right(), "PSM1");
    vision().add("Registration", registration_);
    vision().add("Strand", strand_);
    vision().add("Endoscope", endoscope_);
    vision().add("Tracker", tracker_);
    vision().add("Recorder", recorder_);
    left_.start();
    if (!isOneProcess()) {
      right_.start();
      eyesProcess_.run([this] { vision_.start(); });
    }
    connectAll();
  }
  void stop() {
    vision_.stop();
    right_.stop();
    left_.stop();
  }
  bool is(GuidanceState state) { return guide_->guidance_state() == state; }
  bool becomes(GuidanceState state) {
    return suture::clockOfTest().until([&] { return is(state); });
  }
  suture::Manager& vision() { return isOneProcess() ? left_ : vision_; }
  KnotJudgement judged() {
    stop();
    return judgeKnot(readKnotRecording(file()).rows, kKnotTarget);
  }
  std::string file() const { return directory_.file("knot.jsonl"); }

  GuideParameters guided() const { return {.target = kKnotTarget}; }

  const suture::TemporaryDirectory directory_;
  suture::TestClock::Process eyesProcess_{suture::clockOfTest()};
  suture::loop::ControlThread control_;
  suture::GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  DrivenMtm leftMaster_{Side::Left}, rightMaster_{Side::Right};
  DrivenPsm leftSlave_, rightSlave_;
  KnotSurgeon surgeon_{{.carry = {0.01, 0, -0.07}, .sway = 0.01}};
  std::unique_ptr<KnotGuide> guide_;
  RegistrationTable registration_{knotScene()};
  StrandSimulation strand_{StrandParameters{}};
  SyntheticEndoscope endoscope_{EndoscopeParameters{}};
  KnotTracker tracker_{TrackerParameters{}};
  KnotRecorder recorder_{{.file = file()}};
  suture::Manager left_{"left", names_.address()}, right_{"right", names_.address()},
      vision_{"vision", names_.address()};

 private:
  static bool isOneProcess() { return GetParam() == suture::Lane::Auto; }
  suture::Manager& right() { return isOneProcess() ? left_ : right_; }

  std::string processOf(const suture::Manager& manager) const {
    return &manager == &left_ ? "left" : &manager == &right_ ? "right" : "vision";
  }
  void connect(suture::Manager& client, const std::string& required, suture::Manager& provider,
               const std::string& provided) {
    const bool local = &client == &provider;
    client.connect(required, local ? provided : processOf(provider) + ":" + provided,
                   {.lane = local ? suture::Lane::Auto : GetParam()});
  }
  void connectAll() {
    connect(left_, "Surgeon/Left", left_, "MTML/Arm");
    connect(left_, "Surgeon/Right", right(), "MTMR/Arm");
    connect(left_, "Surgeon/Guidance", left_, "Guide/Guidance");
    connect(left_, "Guide/LeftMaster", left_, "MTML/Arm");
    connect(left_, "Guide/LeftSlave", left_, "PSM2/Arm");
    connect(left_, "Guide/RightMaster", right(), "MTMR/Arm");
    connect(left_, "Guide/RightSlave", right(), "PSM1/Arm");
    connect(left_, "Guide/Vision", vision(), "Tracker/Vision");
    connect(left_, "Guide/Registration", vision(), "Registration/Registration");
    connect(vision(), "Strand/Left", left_, "PSM2/Arm");
    connect(vision(), "Strand/Right", right(), "PSM1/Arm");
    connect(vision(), "Strand/Registration", vision(), "Registration/Registration");
    connect(vision(), "Endoscope/Strand", vision(), "Strand/Strand");
    connect(vision(), "Endoscope/Registration", vision(), "Registration/Registration");
    connect(vision(), "Tracker/Images", vision(), "Endoscope/Images");
    connect(vision(), "Recorder/Strand", vision(), "Strand/Strand");
    connect(vision(), "Recorder/Vision", vision(), "Tracker/Vision");
    connect(vision(), "Recorder/Guidance", left_, "Guide/Guidance");
    connect(vision(), "Recorder/Registration", vision(), "Registration/Registration");
  }
};

INSTANTIATE_TEST_SUITE_P(Lanes, Knot,
                         testing::Values(suture::Lane::Auto, suture::Lane::Shm, suture::Lane::Frame,
                                         suture::Lane::Rpc),
                         [](const auto& one) { return toString(one.param); });

TEST_P(Knot, ComesToItsTargetWithSwayingHands) {
  begin(guided());
  ASSERT_TRUE(becomes(GuidanceState::Guiding));
  suture::pass(6s);
  EXPECT_TRUE(is(GuidanceState::Guiding));
  const std::uint64_t dropped = recorder_.dropped();
  const KnotJudgement judgement = judged();
  for (const std::string& violation : violations(judgement)) ADD_FAILURE() << violation;
  EXPECT_EQ(judgement.sighted, 1);
  EXPECT_EQ(dropped, 0u) << "rows are missing";
}

/// Runs on one lane alone, since no lane has a part in the hands' miss.
class UnguidedKnot : public Knot {};
INSTANTIATE_TEST_SUITE_P(InOneProcess, UnguidedKnot, testing::Values(suture::Lane::Auto),
                         [](const auto& one) { return toString(one.param); });

TEST_P(UnguidedKnot, MissesItsTarget) {
  GuideParameters parameters = guided();
  parameters.fixtures = false;
  begin(parameters);
  ASSERT_TRUE(becomes(GuidanceState::Guiding));
  suture::pass(6s);
  EXPECT_GT(judged().error, 0.003);
}

/// The guide gets nothing but what the cameras see.
TEST_P(Knot, IsNotGuidedUnseen) {
  begin(guided());
  ASSERT_TRUE(becomes(GuidanceState::Guiding));
  suture::pass(1s);
  left_.disconnect("Guide/Vision");
  ASSERT_TRUE(becomes(GuidanceState::Blind));
  const Vector3d leftHeld = leftSlave_.arm.motion().setpoint_cp().pose.translation();
  const Vector3d rightHeld = rightSlave_.arm.motion().setpoint_cp().pose.translation();
  suture::pass(1s);
  EXPECT_TRUE(is(GuidanceState::Blind));
  EXPECT_TRUE(leftSlave_.arm.motion().setpoint_cp().pose.translation().isApprox(leftHeld, 1e-9));
  EXPECT_TRUE(rightSlave_.arm.motion().setpoint_cp().pose.translation().isApprox(rightHeld, 1e-9));
}

/// Both hands have 70 mm to go, and go them once.
TEST_P(UnguidedKnot, IsCarriedOnAfterAnInterruption) {
  begin(guided());
  ASSERT_TRUE(becomes(GuidanceState::Guiding));
  const double start = leftMaster_.arm.motion().setpoint_cp().pose.translation().z();
  suture::pass(2s);
  left_.disconnect("Guide/Vision");
  ASSERT_TRUE(becomes(GuidanceState::Blind));
  const double interrupted = leftMaster_.arm.motion().setpoint_cp().pose.translation().z();
  EXPECT_NEAR(interrupted - start, -0.035, 0.015);
  left_.connect("Guide/Vision", "Tracker/Vision");
  ASSERT_TRUE(becomes(GuidanceState::Guiding));
  suture::pass(4s);
  EXPECT_NEAR(leftMaster_.arm.motion().setpoint_cp().pose.translation().z() - start, -0.07, 1e-6);
}

TEST_P(Knot, AGoneGuideIsNotGuiding) {
  begin(guided());
  ASSERT_TRUE(becomes(GuidanceState::Guiding));
  suture::pass(100ms);
  eyesProcess_.run([this] { vision().disconnect("Recorder/Guidance"); });
  suture::pass(200ms);
  stop();
  const auto rows = readKnotRecording(file()).rows;
  EXPECT_TRUE(
      std::any_of(rows.begin(), rows.end(), [](const KnotRow& row) { return row.guiding; }));
  ASSERT_FALSE(rows.empty());
  EXPECT_FALSE(rows.back().guiding);
}

}  // namespace
}  // namespace robots::test
