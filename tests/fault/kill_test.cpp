// Each role of a system, or provider and client at once, is killed in each phase of its life, on
// each lane; the others' histories stay sound.

#include <gtest/gtest.h>

#include <thread>
#include <tuple>

#include "fault/still/drain.h"
#include "fault/system.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using Kind = HistoryEntry::Kind;

enum class Role { Manager, Provider, Client, Both };
enum class Phase {
  BeforeConnect,
  DuringConnect,
  Idle,
  MidCall,
  MidEvent,
  InADrain,
  DuringShutdown,
};

constexpr const char* kRoles[] = {"Manager", "Provider", "Client", "Both"};
constexpr const char* kPhases[] = {"BeforeConnect", "DuringConnect", "Idle",          "MidCall",
                                   "MidEvent",      "InADrain",      "DuringShutdown"};

class Kill : public testing::TestWithParam<std::tuple<Role, Phase, const char*>> {
 protected:
  Kill() { std::printf("seed %u\n", faultSeed()); }
  Role role() const { return std::get<0>(GetParam()); }
  Phase phase() const { return std::get<1>(GetParam()); }
  const char* lane() const { return std::get<2>(GetParam()); }
  bool killsProvider() const { return role() == Role::Provider || role() == Role::Both; }
  bool killsClient() const { return role() == Role::Client || role() == Role::Both; }
  bool busy() const { return phase() != Phase::Idle; }
  const char* mode() const {
    return phase() == Phase::InADrain ? "bursts" : busy() ? "busy" : "idle";
  }

  void startProvider() {
    provider_ = system_.provider();
    ASSERT_EQ(provider_->line(), "ready");
  }
  void startClient() { client_ = system_.client(mode(), 500, lane()); }
  void kill() {
    if (role() == Role::Manager) kill(*manager_);
    if (killsProvider()) kill(*provider_);
    if (killsClient()) {
      kill(*client_);
      system_.noteKilledClient();
    }
    if (phase() == Phase::InADrain && !killsProvider()) provider_->signal(SIGCONT);
  }
  void kill(Child& victim) {
    if (phase() == Phase::DuringShutdown) {
      victim.signal(SIGTERM);
      pause(3ms);
    }
    const int how = victim.end(SIGKILL);
    EXPECT_TRUE(how == -SIGKILL || phase() == Phase::DuringShutdown) << how;
    ++kills_;
  }
  void restart() {
    if (role() == Role::Manager) manager_ = system_.manager();
    if (killsProvider()) startProvider();
    if (killsClient()) startClient();
  }
  void pause(Duration most) {
    std::this_thread::sleep_for(
        Duration(std::uniform_int_distribution<std::int64_t>(0, most.count())(random_)));
  }
  /// The client has just sent what it awaits the answer of.
  bool calls() const {
    return eventually([this] {
      const HistoryEntry last = system_.clientsHistory().back();
      return last.kind == Kind::Sent && last.limit != Duration{0};
    });
  }
  void awaitConnected() {
    std::string line = client_->line();
    if (line == "begun") line = client_->line();
    ASSERT_EQ(line, "ready");
  }
  void awaitPhase() {
    if (phase() == Phase::DuringConnect) {
      ASSERT_EQ(client_->line(), "begun");
      return pause(10ms);
    }
    awaitConnected();
    ASSERT_TRUE(system_.works(busy()));
    if (phase() == Phase::MidCall) {
      ASSERT_TRUE(calls());
    }
    if (phase() == Phase::MidEvent) {
      ASSERT_TRUE(system_.clientNotes(now(), Kind::Heard));
    }
    if (phase() == Phase::InADrain) stopInADrain(system_, *provider_);
  }

  System system_;
  std::mt19937 random_{faultSeed()};
  std::unique_ptr<Child> manager_ = system_.manager(), provider_, client_;
  int kills_ = 0;
};

INSTANTIATE_TEST_SUITE_P(
    Roles, Kill,
    testing::Combine(testing::Values(Role::Manager, Role::Provider, Role::Client, Role::Both),
                     testing::Values(Phase::BeforeConnect, Phase::DuringConnect, Phase::Idle,
                                     Phase::MidCall, Phase::MidEvent, Phase::InADrain,
                                     Phase::DuringShutdown),
                     testing::Values("shm", "frame", "rpc")),
    [](const auto& test) {
      return std::string(kRoles[static_cast<int>(std::get<0>(test.param))]) +
             kPhases[static_cast<int>(std::get<1>(test.param))] + "_" + std::get<2>(test.param);
    });

TEST_P(Kill, LeavesSoundHistoriesWhileOthersGoOn) {
  startProvider();
  if (killsClient() || phase() != Phase::BeforeConnect) startClient();
  if (phase() != Phase::BeforeConnect) awaitPhase();
  ASSERT_FALSE(HasFatalFailure());
  kill();
  if (client_ == nullptr) startClient();
  restart();
  if (killsClient() || phase() <= Phase::DuringConnect) awaitConnected();
  EXPECT_TRUE(system_.works(busy()));
  EXPECT_EQ(client_->end(SIGTERM), 0);
  EXPECT_EQ(provider_->end(SIGTERM), 0);
  EXPECT_EQ(manager_->end(SIGTERM), 0);
  const auto history = system_.history();
  EXPECT_EQ(system_.lanes(), System::Lanes{lane()});
  EXPECT_TRUE(system_.haveReported());
  expectSoundHistory(history);
  std::printf("%d killed, %zu entries\n", kills_, history.size());
  EXPECT_GT(kills_, 0);
}

}  // namespace
}  // namespace suture
