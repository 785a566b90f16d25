// Two tasks that wait for each other's answers are named, because neither can know it by itself.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/task/continuous_task.h>
#include <suture/component/task/event_task.h>

#include <array>
#include <atomic>
#include <chrono>
#include <string>
#include <vector>

#include "reference/still_arm.h"
#include "support/eventually.h"
#include "unit/deploy/host_scene.h"

namespace suture::test {
namespace {

/// Waits for another arm, and does nothing else.
class Asking final : public ContinuousTask, public StillArm {
 private:
  void run() override { (void)other_.reset.start().within(20ms); }

  Provided<reference::ArmLike> port_{*this, "Arm", *this};
  Required<reference::ArmLike> other_{*this, "Other"};
};

/// Waits in its handler for who has called.
template <int kMilliseconds>
class AskingBack final : public EventTask, public StillArm {
 public:
  std::uint32_t reset() override {
    (void)other_.reset.start().within(std::chrono::milliseconds(kMilliseconds));
    return 0;
  }

 private:
  void run() override {}

  Provided<reference::ArmLike> port_{*this, "Arm", *this};
  Required<reference::ArmLike> other_{*this, "Other"};
};

class Answering final : public EventTask, public StillArm {
 public:
  std::uint32_t reset() override {
    eventually([] { return mayAnswer.load(); });
    return 0;
  }
  static inline std::atomic<bool> mayAnswer{false};

 private:
  void run() override {}

  Provided<reference::ArmLike> port_{*this, "Arm", *this};
  Required<reference::ArmLike> other_{*this, "Other"};
};

const std::array kArms{
    ComponentClass{"Asking", createWithoutParameters<Asking>},
    ComponentClass{"Patient", createWithoutParameters<AskingBack<60'000>>},
    ComponentClass{"Hasty", createWithoutParameters<AskingBack<5>>},
    ComponentClass{"Answering", createWithoutParameters<Answering>},
};

/// Returns two arms that require each other, the second of that class.
Deployment pair(const std::string& second) {
  return deploymentOf(
      "{\"name\": \"A\", \"class\": \"Asking\"},\n{\"name\": \"B\", \"class\": \"" + second + "\"}",
      "{\"from\": \"A/Other\", \"to\": \"B/Arm\"},\n"
      "{\"from\": \"B/Other\", \"to\": \"A/Arm\"}");
}

std::string textOf(const std::string& connection, const std::string& one,
                   const std::string& other) {
  return "connection '" + connection + "': '" + one + "' waited for '" + other +
         "' until its deadline, and a command of '" + other + "' waited for '" + one +
         "', which ends none while it waits. Let one of the two look at its answer with poll() "
         "or then()";
}

TEST(MutualWait, TheCallerNamesWhomItWaitsFor) {
  const Deployment deployment = pair("Patient");
  Host host(deployment, "all", kArms);
  host.start();
  EXPECT_EQ(newsOf(host),
            std::vector<std::string>{textOf("all:A/Other -> all:B/Arm", "all:A", "all:B")});
}

TEST(MutualWait, TheCalledHandlerNamesItsCaller) {
  const Deployment deployment = pair("Hasty");
  Host host(deployment, "all", kArms);
  host.start();
  EXPECT_EQ(newsOf(host).front(), textOf("all:B/Other -> all:A/Arm", "all:B", "all:A"));
}

TEST(MutualWait, ASlowAnswerIsNone) {
  const Deployment deployment = pair("Answering");
  Host host(deployment, "all", kArms);
  host.start();
  const auto channels = host.manager().channels();
  EXPECT_TRUE(eventually([&] { return channels[0]->commands.counters.sent > 2; }));
  EXPECT_EQ(host.news(), std::vector<std::string>{});
  Answering::mayAnswer = true;
}

}  // namespace
}  // namespace suture::test
