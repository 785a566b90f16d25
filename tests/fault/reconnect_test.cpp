// Peers and managers are killed and started again.

#include <gtest/gtest.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <algorithm>
#include <cstdlib>

#include "fault/operator.h"
#include "paths.h"
#include "support/child.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "support/resources.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

int rounds() {
  const char* asked = std::getenv("SUTURE_RECONNECTS");
  return asked == nullptr ? 50 : std::atoi(asked);
}

struct Held {
  std::size_t descriptors = openDescriptors(), threads = suture::threads(), bytes = residentBytes();
};

Duration medianOf(std::vector<Duration> all) {
  std::sort(all.begin(), all.end());
  return all[all.size() / 2];
}

bool hearsAgain(const Operator& client) {
  const int heard = client.heard;
  return eventually([&] { return client.error == Errc{} && client.heard > heard; });
}

class Restarts : public testing::TestWithParam<const char*> {
 protected:
  std::string address(const char* file) const {
    return std::string(GetParam()) == "unix" ? "unix:" + directory_.file(file)
                                             : "tcp://127.0.0.1:0";
  }
  std::unique_ptr<Child> provider(const std::string& manager) const {
    auto child = std::make_unique<Child>(
        std::vector<std::string>{paths::kFaultyHost, manager, "there", directory_.file("hang")});
    EXPECT_EQ(child->line(), "ready");
    return child;
  }

  const TemporaryDirectory directory_;
};

INSTANTIATE_TEST_SUITE_P(Sockets, Restarts, testing::Values("unix", "tcp"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(Restarts, ManyRestartsOfAPeerCostNothing) {
  loop::ControlThread control;
  const GlobalManager names(control, address("m.sock"));
  auto child = provider(names.address());
  Operator client;
  Manager here("here", names.address());
  here.add("Operator", client);
  here.start();
  here.connect("Operator/Arm", "there:PSM1/Arm",
               {.patience = kPatience, .contract = {.silence = 5s}});
  ASSERT_TRUE(hearsAgain(client));

  const int all = rounds(), warm = std::max(all / 5, 1);
  std::vector<Duration> back;
  Held before;
  for (int round = 0; round < all; ++round) {
    if (round == warm) before = {};
    child->end(SIGKILL);
    ASSERT_TRUE(eventually([&] { return client.error == Errc::Lost; })) << round;
    child = provider(names.address());
    const Time ready = now();
    ASSERT_TRUE(eventually([&] { return client.error == Errc{}; })) << round;
    back.push_back(now() - ready);
    ASSERT_TRUE(hearsAgain(client)) << "it is subscribed again, round " << round;
    ASSERT_EQ(here.channels().size(), 1u);
  }
  EXPECT_EQ(here.channels()[0]->terms.watch->losses, static_cast<std::uint64_t>(all));
  // The latest restart may have left something that is on its way.
  EXPECT_TRUE(eventually([&] { return openDescriptors() == before.descriptors; }))
      << openDescriptors() << " descriptors after " << before.descriptors;
  EXPECT_TRUE(eventually([&] { return threads() == before.threads; }))
      << threads() << " threads after " << before.threads;
  if (kGivesMemoryBack) {
    EXPECT_LE(residentBytes(), before.bytes + (1u << 20));
  }
  EXPECT_LE(entriesOf(directory_.path().c_str()), 3u) << "sockets of the dead are left";
  const auto longest = *std::max_element(back.begin(), back.end());
  std::printf("%d restarts, back after %.1f ms (median), %.1f ms (longest)\n", all,
              std::chrono::duration<double, std::milli>(medianOf(back)).count(),
              std::chrono::duration<double, std::milli>(longest).count());
}

TEST_P(Restarts, ARestartedManagerLearnsTheNamesAgain) {
  std::string at = address("m.sock");
  const auto manager = [&at] {
    auto child =
        std::make_unique<Child>(std::vector<std::string>{paths::kSutureManager, "--listen", at});
    const std::string line = child->line(), said = "suture-manager: ready on ";
    EXPECT_TRUE(line.starts_with(said)) << line;
    at = line.substr(said.size());
    return child;
  };
  auto names = manager();
  const auto child = provider(at);
  Operator client;
  Manager here("here", at);
  here.add("Operator", client);
  here.start();
  here.connect("Operator/Arm", "there:PSM1/Arm");
  ASSERT_TRUE(hearsAgain(client));
  const auto channels = here.channels();
  for (int round = 0; round < 5; ++round) {
    names->end(SIGKILL);
    EXPECT_TRUE(eventually([&] { return here.missingGlobalManager() == at; }));
    EXPECT_TRUE(hearsAgain(client));
    names = manager();
    Operator another;
    Manager third("third" + std::to_string(round), at);
    third.add("Operator", another);
    third.start();
    third.connect("Operator/Arm", "there:PSM2/Arm");
    EXPECT_TRUE(hearsAgain(another));
    EXPECT_TRUE(eventually([&] { return here.missingGlobalManager().empty(); }));
  }
  EXPECT_EQ(here.channels(), channels) << "nothing was lost meanwhile";
}

TEST_P(Restarts, ManagerAndPeerMayRestartTogether) {
  std::string at = address("m.sock");
  loop::ControlThread control;
  auto names = std::make_unique<GlobalManager>(control, at);
  at = names->address();
  auto child = provider(at);
  Operator client;
  Manager here("here", at);
  here.add("Operator", client);
  here.start();
  here.connect("Operator/Arm", "there:PSM1/Arm");
  for (int round = 0; round < 3; ++round) {
    ASSERT_TRUE(hearsAgain(client));
    names.reset();
    child->end(SIGKILL);
    ASSERT_TRUE(eventually([&] { return client.error == Errc::Lost; }));
    ASSERT_TRUE(eventually([&] { return here.missingGlobalManager() == at; }));
    names = std::make_unique<GlobalManager>(control, at);
    child = provider(at);
    ASSERT_TRUE(hearsAgain(client));
  }
}

TEST_P(Restarts, AnAnswerOfAnOlderEpochDrops) {
  loop::ControlThread control;
  const GlobalManager names(control, address("m.sock"));
  const auto child = provider(names.address());
  Operator client;
  Manager here("here", names.address());
  here.add("Operator", client);
  here.start();
  here.connect("Operator/Arm", "there:PSM1/Arm",
               {.patience = kPatience, .contract = {.silence = 500ms}});
  std::vector<std::uint32_t> answers;
  for (int round = 0; round < 3; ++round) {
    client.resets = 0;
    ASSERT_TRUE(hearsAgain(client));
    child->signal(SIGSTOP);
    client.resets = 1;  // leaves, and is not answered before the connection is lost
    ASSERT_TRUE(eventually([&] { return client.error == Errc::Lost; }));
    EXPECT_TRUE(eventually([&] { return client.resetEnd != Errc::NotYet; }));
    EXPECT_NE(client.resetEnd, Errc{});
    child->signal(SIGCONT);
    ASSERT_TRUE(hearsAgain(client));
    ASSERT_TRUE(eventually([&] {
      if (client.resetEnd == Errc{}) return true;
      // On a machine that does something else it may be lost once more.
      if (client.resetEnd.exchange(Errc::NotYet) != Errc::NotYet) client.resets = 1;
      return false;
    }));
    answers.push_back(client.answer);
    client.resetEnd = Errc::NotYet;
  }
  // The arm counts them: an answer that came late would be told once more.
  EXPECT_TRUE(std::is_sorted(answers.begin(), answers.end(), std::less_equal<>()))
      << answers.back();
}

}  // namespace
}  // namespace suture
