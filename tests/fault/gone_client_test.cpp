// A provider is told that the process of its client has been killed, or says nothing any more.

#include <gtest/gtest.h>
#include <suture/component/task/periodic_task.h>
#include <suture/manager/manager.h>

#include <atomic>
#include <csignal>
#include <memory>

#include "fault/system.h"
#include "reference/still_arm.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

/// Counts what it is told of its clients.
struct ToldArm final : PeriodicTask, StillArm {
  ToldArm() : PeriodicTask({.period = 1ms}) {}
  ~ToldArm() override { stop(); }
  void run() override {}
  void onClient(const ProvidedBase&, const ConnectedClient& client, ClientNews news) override {
    EXPECT_TRUE(client.name.ends_with(":Client/Arm")) << client.name;
    if (news == ClientNews::Connected) ++connected;
    if (news == ClientNews::Closed) ++closed;
    if (news == ClientNews::Silent) ++silent;
  }

  std::atomic<int> connected{0}, closed{0}, silent{0};
  Provided<reference::ArmLike> port{*this, "Arm", *this};
};

/// The provider lives in the test's process, each client in one of its own.
class ToldOfClients : public testing::TestWithParam<const char*> {
 protected:
  ToldOfClients() {
    robot_.add("PSM", arm_);
    robot_.start();
  }
  ~ToldOfClients() override { robot_.stop(); }

  std::unique_ptr<Child> startClient(int silenceMilliseconds) {
    auto client = system_.client("busy", silenceMilliseconds, GetParam());
    EXPECT_EQ(client->line(), "begun");
    EXPECT_EQ(client->line(), "ready");
    return client;
  }

  System system_;
  const std::unique_ptr<Child> manager_ = system_.manager();
  ToldArm arm_;
  Manager robot_{"robot", system_.address()};
};

INSTANTIATE_TEST_SUITE_P(Lanes, ToldOfClients, testing::Values("shm", "frame", "rpc"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(ToldOfClients, AKilledProcessIsGoneAtOnce) {
  const auto client = startClient(60'000);  // no lease ends in this test
  ASSERT_TRUE(eventually([&] { return arm_.connected == 1; }));
  EXPECT_EQ(client->end(SIGKILL), -SIGKILL);
  EXPECT_TRUE(eventually([&] { return arm_.closed == 1; }));
  const auto next = startClient(60'000);
  EXPECT_TRUE(eventually([&] { return arm_.connected == 2; }));
  EXPECT_EQ(arm_.closed, 1);
  EXPECT_EQ(arm_.silent, 0);
}

TEST_P(ToldOfClients, AStoppedProcessIsSilent) {
  const auto client = startClient(300);
  ASSERT_TRUE(eventually([&] { return arm_.connected == 1; }));
  client->signal(SIGSTOP);
  EXPECT_TRUE(eventually([&] { return arm_.silent + arm_.closed == 1; }));
  EXPECT_EQ(arm_.silent, 1);
  client->signal(SIGCONT);
  EXPECT_TRUE(eventually([&] { return arm_.connected == 2; })) << "it comes back";
  EXPECT_EQ(arm_.silent, 1);
}

}  // namespace
}  // namespace suture
