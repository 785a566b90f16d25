// The wall clocks of a manager, a provider and a client step forwards and backwards, each for
// itself, while the client commands its provider.

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <iterator>

#include "fault/system.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

constexpr int kSteps = 40;
constexpr std::chrono::seconds kOffsets[] = {0s, 1s, -1s, 1h, -1h, 24h, -24h};

/// Some processes have this for a wall clock, by Debian's libfaketime. Their steady clocks and the
/// machine's own stay as they are.
class WallClock {
 public:
  explicit WallClock(std::string file) : file_(std::move(file)) { stepTo(0s); }

  /// Gives it to this process's next program.
  void enter() const {
    setenv("LD_PRELOAD", FAKETIME_LIBRARY, 1);
    setenv("FAKETIME_TIMESTAMP_FILE", file_.c_str(), 1);
    setenv("FAKETIME_NO_CACHE", "1", 1);
    setenv("FAKETIME_DONT_FAKE_MONOTONIC", "1", 1);
  }
  /// Sets it so much ahead of the machine's from now on.
  void stepTo(std::chrono::seconds ahead) {
    ahead_ = ahead;
    std::ofstream(file_ + ".new") << (ahead < 0s ? "" : "+") << ahead.count() << "\n";
    std::filesystem::rename(file_ + ".new", file_);
  }
  std::chrono::seconds ahead() const { return ahead_; }

 private:
  const std::string file_;
  std::chrono::seconds ahead_{0};
};

/// Returns how far ahead of the machine's wall clock that of the entry's writer was.
std::chrono::seconds aheadAt(const HistoryEntry& entry) {
  const auto machine = std::chrono::system_clock::now().time_since_epoch() -
                       now().time_since_epoch() + entry.at.time_since_epoch();
  return std::chrono::round<std::chrono::seconds>(Duration(entry.wall) - machine);
}

/// The latest provider, or the latest client, has written this down last.
HistoryEntry newest(const System& system, bool provider) {
  const auto history = provider ? system.providersHistory() : system.clientsHistory();
  return history.empty() ? HistoryEntry{} : history.back();
}

bool has(const Child& child, const std::string& library) {
  std::ifstream maps("/proc/" + std::to_string(child.pid()) + "/maps");
  const std::string text((std::istreambuf_iterator<char>(maps)), {});
  return text.find(library) != std::string::npos;
}

class ClockSteps : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Lanes, ClockSteps, testing::Values("auto", "frame", "rpc"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(ClockSteps, AreNothingToAConnection) {
  System system;
  enum Role { Manager, Provider, Client };
  std::array<WallClock, 3> clocks{WallClock(system.file("manager.clock")),
                                  WallClock(system.file("provider.clock")),
                                  WallClock(system.file("client.clock"))};
  const auto manager = system.manager([&] { clocks[Manager].enter(); });
  const auto provider = system.provider("robot", [&] { clocks[Provider].enter(); });
  ASSERT_EQ(provider->line(), "ready");
  const auto client = system.client("busy", 5000, GetParam(), [&] { clocks[Client].enter(); });
  ASSERT_EQ(client->line(), "begun");
  ASSERT_EQ(client->line(), "ready");
  for (const Child* child : {manager.get(), provider.get(), client.get()}) {
    ASSERT_TRUE(has(*child, "libfaketime"));
  }

  std::mt19937 random(faultSeed());
  int steps = 0;
  while (steps < kSteps) {
    const auto role = std::uniform_int_distribution<std::size_t>(0, 2)(random);
    const auto ahead =
        kOffsets[std::uniform_int_distribution<std::size_t>(0, std::size(kOffsets) - 1)(random)];
    if (ahead == clocks[role].ahead()) continue;
    clocks[role].stepTo(ahead);
    ++steps;
    // The manager does nothing that depends on its wall clock, and so cannot show it.
    ASSERT_TRUE(role == Manager ||
                eventually([&] { return aheadAt(newest(system, role == Provider)) == ahead; }))
        << "the clock was not stepped";
    ASSERT_TRUE(system.works(true)) << "after a step to " << ahead.count() << " s";
  }
  for (const HistoryEntry& entry : system.clientsHistory()) {
    const bool event = entry.kind == HistoryEntry::Kind::Heard;
    ASSERT_TRUE(event || entry.epoch == 1) << "it reconnected";
  }

  // A client that comes now is as welcome.
  clocks[Client].stepTo(-24h);
  clocks[Provider].stepTo(24h);
  const auto second = system.client("busy", 5000, GetParam(), [&] { clocks[Client].enter(); });
  ASSERT_EQ(second->line(), "begun");
  ASSERT_EQ(second->line(), "ready");
  EXPECT_TRUE(system.works(true));
  for (Child* child : {second.get(), client.get(), provider.get(), manager.get()}) {
    EXPECT_EQ(child->end(SIGTERM), 0);
  }
  expectSoundHistory(system.history());
  std::printf("seed %u: %d steps, %zu entries\n", faultSeed(), steps, system.history().size());
  EXPECT_GT(steps, 0);
}

}  // namespace
}  // namespace suture
