// Each role of a system is stopped and goes on, again and again, at any moment.

#include <gtest/gtest.h>

#include <thread>

#include "fault/system.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

enum class Role { Manager, Provider, Client };
constexpr const char* kRoles[] = {"Manager", "Provider", "Client"};

constexpr Duration kStopped = 700ms;  // longer than the silence that the connection bears
constexpr int kRounds = 3;

class Stop : public testing::TestWithParam<Role> {};

INSTANTIATE_TEST_SUITE_P(Roles, Stop, testing::Values(Role::Manager, Role::Provider, Role::Client),
                         [](const auto& test) {
                           return std::string(kRoles[static_cast<int>(test.param)]);
                         });

TEST_P(Stop, LeavesSoundHistories) {
  System system;
  const auto manager = system.manager(), provider = system.provider();
  ASSERT_EQ(provider->line(), "ready");
  const auto client = system.client("busy", 300);
  ASSERT_EQ(client->line(), "begun");
  ASSERT_EQ(client->line(), "ready");
  Child& stopped = GetParam() == Role::Manager    ? *manager
                   : GetParam() == Role::Provider ? *provider
                                                  : *client;
  std::mt19937 random(faultSeed());
  int stops = 0;
  for (; stops < kRounds; ++stops) {
    ASSERT_TRUE(system.works(true));
    std::this_thread::sleep_for(
        std::chrono::microseconds(std::uniform_int_distribution<int>(0, 20'000)(random)));
    stopped.signal(SIGSTOP);
    std::this_thread::sleep_for(kStopped);
    stopped.signal(SIGCONT);
  }
  EXPECT_TRUE(system.works(true));
  EXPECT_EQ(client->end(SIGTERM), 0);
  EXPECT_EQ(provider->end(SIGTERM), 0);
  EXPECT_EQ(manager->end(SIGTERM), 0);
  expectSoundHistory(system.history(), kBusyMachine + kStopped);  // who is stopped is late
  std::printf("seed %u: %d stops, %zu entries\n", faultSeed(), stops, system.history().size());
  EXPECT_GT(stops, 0);
}

}  // namespace
}  // namespace suture
