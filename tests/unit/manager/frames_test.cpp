// Two processes whose interfaces declare different coordinate frames are not connected, whichever
// lane is asked for.
#include <gtest/gtest.h>
#include <suture/component/task/event_task.h>
#include <suture/names/describe.h>

#include <chrono>
#include <memory>
#include <string>

#include "reference/arm_like.suture.h"
#include "reference/still_arm.h"
#include "support/eventually.h"
#include "support/refusal.h"
#include "unit/manager/two_processes.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

struct FramedArm final : EventTask, StillArm {
  explicit FramedArm(const Frames& frames) { port.declareFrames(frames); }
  ~FramedArm() override { stop(); }
  void run() override {}
  Provided<reference::ArmLike> port{*this, "Arm", *this};
};

struct FramedClient final : EventTask {
  FramedClient() { arm.declareFrames({"PSM2_base", "PSM2_tip"}); }
  ~FramedClient() override { stop(); }
  void run() override {}
  Required<reference::ArmLike> arm{*this, "Arm"};
};

class RemoteFrames : public testing::TestWithParam<Lane> {
 protected:
  void begin(const Frames& provided) {
    arm_ = std::make_unique<FramedArm>(provided);
    processes_.there.add("PSM", *arm_);
    processes_.here.add("Guide", client_);
    processes_.start();
  }
  void connect() { processes_.here.connect("Guide/Arm", "there:PSM/Arm", {.lane = GetParam()}); }
  void stop() {
    processes_.here.stop();
    processes_.there.stop();
  }

  std::unique_ptr<FramedArm> arm_;
  FramedClient client_;
  TwoProcesses processes_;
};

INSTANTIATE_TEST_SUITE_P(Lanes, RemoteFrames, testing::Values(Lane::Shm, Lane::Frame, Lane::Rpc),
                         [](const auto& one) { return toString(one.param); });

TEST_P(RemoteFrames, DifferentFramesAreNotConnected) {
  begin({"PSM1_base", "PSM1_tip"});
  testing::internal::CaptureStderr();
  const std::string text = refusal([&] { connect(); });
  const std::string told = testing::internal::GetCapturedStderr();
  const std::string why =
      "connecting here:Guide/Arm -> there:PSM/Arm: it expects reference frame 'PSM2_base' and is "
      "offered 'PSM1_base', and moving frame 'PSM2_tip' and is offered 'PSM1_tip'.";
  EXPECT_NE(text.find(why), std::string::npos) << text;
  EXPECT_NE(told.find(why), std::string::npos) << "the provider tells it too: " << told;
  EXPECT_TRUE(processes_.here.channels().empty());
  stop();
}

TEST_P(RemoteFrames, EqualOrUndeclaredFramesAreConnected) {
  begin({"PSM2_base", ""});
  connect();
  EXPECT_EQ(processes_.here.channels().size(), 1u);
  stop();
}

TEST(LocalFrames, ADelayDoesNotConnectDifferentFrames) {
  FramedArm arm({"PSM1_base", ""});
  FramedClient client;
  Manager manager("here");
  manager.add("PSM", arm);
  manager.add("Guide", client);
  manager.start();
  const std::string text =
      refusal([&] { manager.connect("Guide/Arm", "PSM/Arm", {.delay = {.commands = 1ms}}); });
  EXPECT_NE(text.find("expects reference frame 'PSM2_base'"), std::string::npos) << text;
  manager.stop();
}

TEST(ListedFrames, AreThoseOfEachInterface) {
  FramedArm arm({"PSM1_base", "PSM1_tip"});
  TwoProcesses processes;
  processes.there.add("PSM", arm);
  processes.start();
  const auto components = describeComponents(processes.there.directory());
  ASSERT_EQ(components.size(), 1u);
  EXPECT_EQ(components[0].provided.at(0).frames, (Frames{"PSM1_base", "PSM1_tip"}));
  processes.here.stop();
  processes.there.stop();
}

}  // namespace
}  // namespace suture
