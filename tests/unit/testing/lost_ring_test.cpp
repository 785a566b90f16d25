// The threads that carry lanes may not find by chance what nobody has rung them for.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/device.h>
#include <suture/component/task/event_task.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/testing/test_clock.h>

#include <memory>
#include <string>
#include <vector>

#include "reference/still_arm.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

struct QuietArm final : EventTask, StillArm {
  ~QuietArm() override { stop(); }
  void run() override {}
  Provided<reference::ArmLike> port{*this, "Arm", *this};
};

struct RareCaller final : Device {
  Required<reference::ArmLike> arm{*this, "Arm"};
};

/// Nothing happens in two processes but what the test has them do, and heartbeats.
class LostRing : public testing::TestWithParam<Lane> {
 protected:
  LostRing() {
    robot_->add("PSM", arm_);
    console_->add("Caller", caller_);
    robot_->start();
    console_->start();
    console_->connect("Caller/Arm", "robot:PSM/Arm", {.lane = GetParam()});
    clock_.advance(5s);
  }
  ~LostRing() override {
    console_->stop();
    robot_->stop();
  }

  std::vector<std::string> problems_;
  TestClock clock_{{.problem = [this](const std::string& one) { problems_.push_back(one); }}};
  const TemporaryDirectory directory_;
  loop::ControlThread control_;
  GlobalManager global_{control_, "unix:" + directory_.file("manager.sock")};
  QuietArm arm_;
  RareCaller caller_;
  const std::unique_ptr<Manager> robot_ = std::make_unique<Manager>("robot", global_.address()),
                                 console_ = std::make_unique<Manager>("console", global_.address());
};

INSTANTIATE_TEST_SUITE_P(Lanes, LostRing, testing::Values(Lane::Frame, Lane::Rpc),
                         [](const auto& one) { return toString(one.param); });

TEST_P(LostRing, OfALaneIsTold) {
  EXPECT_TRUE(caller_.arm.hold());
  console_->channels().at(0)->ends.provider->takeRing();  // as a defect would lose it
  clock_.advance(5s);
  EXPECT_EQ(arm_.holds, 1);
  const char* const thread = GetParam() == Lane::Frame ? "'lane'" : "'control'";
  EXPECT_THAT(problems_, testing::ElementsAre(testing::AllOf(
                             testing::HasSubstr(thread), testing::HasSubstr("nobody had rung"))));
}

TEST_P(LostRing, IsNoneInAQuietSystem) {
  for (int i = 0; i < 10; ++i) {
    EXPECT_TRUE(caller_.arm.hold());
    clock_.advance(5s);
  }
  EXPECT_EQ(arm_.holds, 10);
  EXPECT_TRUE(problems_.empty()) << problems_.front();
}

}  // namespace
}  // namespace suture
