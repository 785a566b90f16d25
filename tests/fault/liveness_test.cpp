// A provider's process stops, a task in it hangs, and one only sleeps.

#include <gtest/gtest.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/observe/observe.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "fault/operator.h"
#include "paths.h"
#include "support/child.h"
#include "support/contains.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

constexpr Duration kSilence = 500ms;

class Liveness : public testing::TestWithParam<const char*> {
 protected:
  Liveness()
      : names_(control_, std::string(GetParam()) == "unix" ? "unix:" + directory_.file("m.sock")
                                                           : "tcp://127.0.0.1:0"),
        here_("here", names_.address()) {
    EXPECT_EQ(host_.line(), "ready");
    here_.add("First", first_);
    here_.add("Second", second_);
    here_.add("Third", third_);
    here_.start();
  }
  void connect(const std::string& required, const std::string& provided,
               Duration silence = kSilence) {
    here_.connect(required, provided, {.patience = kPatience, .contract = {.silence = silence}});
  }
  std::string whyLost(const std::string& from, const std::string& to) const {
    const auto why = here_.whyLost();
    const auto found = why.find("here:" + from + " -> there:" + to);
    return found == why.end() ? "" : found->second;
  }
  void hang(Operator& client, double speed) {
    std::ofstream(hangFile_).put('!');
    client.limit = speed;
  }
  void expectRefused(const std::string& required, const std::string& provided) {
    const std::string why = refusal([&] { connect(required, "there:" + provided); });
    const std::string component = provided.substr(0, provided.find('/'));
    EXPECT_TRUE(contains(
        why, "the provider is hung: the thread of '" + component + "' has been in one cycle for"))
        << why;
  }
  void stopHanging() { std::filesystem::remove(hangFile_); }

  const TemporaryDirectory directory_;
  const std::string hangFile_ = directory_.file("hang");
  loop::ControlThread control_;
  GlobalManager names_;
  Child host_{{paths::kFaultyHost, names_.address(), "there", hangFile_}};
  Operator first_, second_, third_;
  Manager here_;
};

INSTANTIATE_TEST_SUITE_P(Sockets, Liveness, testing::Values("unix", "tcp"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(Liveness, AStoppedProcessIsLost) {
  connect("First/Arm", "there:PSM1/Arm");
  for (int round = 0; round < 3; ++round) {
    ASSERT_TRUE(eventually([&] { return first_.error == Errc{}; }));
    const int heard = first_.heard;
    ASSERT_TRUE(eventually([&] { return first_.heard > heard; }));
    const auto before = here_.channels().at(0);
    host_.signal(SIGSTOP);
    ASSERT_TRUE(eventually([&] { return before->status == ChannelStatus::Lost; }));
    EXPECT_TRUE(eventually([&] { return first_.error == Errc::Lost; })) << "the component is told";
    EXPECT_TRUE(whyLost("First/Arm", "PSM1/Arm").starts_with("silent: "));
    host_.signal(SIGCONT);
    ASSERT_TRUE(eventually([&] { return here_.channels().at(0) != before; })) << "a new epoch";
    EXPECT_NE(before->status, ChannelStatus::Connected) << "which the old one has no part in";
  }
}

// Both connections are in one session and hear the same heartbeat, but each judges it by its own
// silence.
TEST_P(Liveness, ALongerSilenceHoldsForItsConnection) {
  connect("First/Arm", "there:PSM1/Arm", 200ms);
  connect("Second/Arm", "there:PSM2/Arm", 1min);
  ASSERT_TRUE(eventually([&] { return first_.error == Errc{} && second_.error == Errc{}; }));
  for (int round = 0; round < 2; ++round) {
    host_.signal(SIGSTOP);
    EXPECT_TRUE(eventually([&] { return first_.error == Errc::Lost; }));
    host_.signal(SIGCONT);
    EXPECT_TRUE(eventually([&] { return first_.error == Errc{}; })) << "it comes back alone";
  }
  EXPECT_EQ(whyLost("Second/Arm", "PSM2/Arm"), "");
  const int heard = second_.heard;
  EXPECT_TRUE(eventually([&] { return second_.heard > heard; }));
  EXPECT_EQ(second_.error, Errc{});
}

TEST_P(Liveness, AHungTaskIsLostAlone) {
  for (const auto& [provider, speed] :
       {std::pair("PSM1/Arm", 0.0), std::pair("PSM1/Arm", 1.0), std::pair("PSM2/Arm", 0.0)}) {
    const std::string neighbour = provider == std::string("PSM1/Arm") ? "PSM2/Arm" : "PSM1/Arm";
    connect("First/Arm", std::string("there:") + provider);
    connect("Second/Arm", "there:" + neighbour);
    ASSERT_TRUE(eventually([&] { return first_.error == Errc{} && second_.error == Errc{}; }));
    hang(first_, speed);
    ASSERT_TRUE(eventually([&] { return first_.error == Errc::Lost; }));
    EXPECT_TRUE(whyLost("First/Arm", provider).starts_with("hung: ")) << provider;
    // No other client can connect to the provider while it hangs.
    const int heard = second_.heard;
    expectRefused("Third/Arm", provider);
    EXPECT_EQ(first_.error, Errc::Lost);
    EXPECT_TRUE(eventually([&] { return second_.heard > heard; }));
    EXPECT_TRUE(eventually([&] { return second_.error == Errc{}; }));
    EXPECT_FALSE(whyLost("Second/Arm", neighbour).starts_with("hung: "));
    stopHanging();
    EXPECT_TRUE(eventually([&] { return first_.error == Errc{}; }));
    here_.disconnect("First/Arm");
    here_.disconnect("Second/Arm");
    ASSERT_TRUE(eventually([&] { return first_.error == Errc::NotConnected; }));
  }
}

// The task that hangs has a silence that is ten times as long as that of the task that sleeps. When
// it is found to hang, the other would have been found long before.
TEST_P(Liveness, ASleepingTaskIsNotHung) {
  first_.asks = false;
  second_.asks = false;
  connect("First/Arm", "there:PSM1/Arm", 1s);
  connect("Second/Arm", "there:PSM2/Arm", 10s);
  ASSERT_TRUE(eventually([&] { return first_.error == Errc{} && second_.error == Errc{}; }));
  hang(second_, 0);
  ASSERT_TRUE(eventually([&] { return whyLost("Second/Arm", "PSM2/Arm").starts_with("hung: "); }));
  // A busy machine may keep the whole process silent for so long, so the connection may be lost,
  // but not as hung.
  EXPECT_FALSE(whyLost("First/Arm", "PSM1/Arm").starts_with("hung: "));
  EXPECT_TRUE(eventually([&] { return first_.error == Errc{}; }));
  stopHanging();
}

TEST_P(Liveness, ConnectingToAHungProviderIsRefused) {
  connect("First/Arm", "there:PSM1/Arm");
  hang(first_, 0);
  ASSERT_TRUE(eventually([&] { return first_.error == Errc::Lost; }));
  expectRefused("Second/Arm", "PSM1/Arm");
  stopHanging();
  ASSERT_TRUE(eventually([&] { return first_.error == Errc{}; }));
  connect("Second/Arm", "there:PSM1/Arm");
}

TEST_P(Liveness, ASilenceBelowTheHeartbeatIsRefused) {
  const std::string why = refusal([&] { connect("First/Arm", "there:PSM1/Arm", 1ms); });
  EXPECT_NE(why.find("Allow at least 10 ms"), std::string::npos) << why;
}

TEST_P(Liveness, AKilledProcessIsLostAsEnded) {
  connect("First/Arm", "there:PSM1/Arm");
  host_.end(SIGKILL);
  EXPECT_TRUE(eventually([&] { return first_.error == Errc::Lost; }));
  EXPECT_TRUE(whyLost("First/Arm", "PSM1/Arm").starts_with("closed: "));
  const Report report = observe(here_, now());
  ASSERT_EQ(report.connections.size(), 1u);
  EXPECT_TRUE(report.connections[0].whyLost.starts_with("closed: ")) << "people can see why";
}

}  // namespace
}  // namespace suture
