// Processes whose commands await an operator stand still (SIGSTOP), on each lane. A loss ends what
// was accepted before it, and neither a loss nor a stale read lets through what follows, until the
// operator does.

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <tuple>

#include "fault/still/drain.h"
#include "fault/system.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

enum class Victim { Provider, Client, Both };
constexpr const char* kVictims[] = {"Provider", "Client", "Both"};

class OperatorsGate : public testing::TestWithParam<std::tuple<Victim, const char*>> {
 protected:
  Victim victim() const { return std::get<Victim>(GetParam()); }
  const char* lane() const { return std::get<const char*>(GetParam()); }

  void begin(const char* mode, std::chrono::milliseconds silence) {
    ASSERT_EQ(provider_->line(), "ready");
    client_ = system_.client(mode, static_cast<int>(silence.count()), lane());
    ASSERT_EQ(client_->line(), "begun");
    ASSERT_EQ(client_->line(), "ready");
    ASSERT_TRUE(system_.works(true));
  }
  /// Lets a client that stands still go on after so long, which nothing but the clock can tell.
  void goOn(Duration stop) {
    if (victim() == Victim::Provider) return;
    std::this_thread::sleep_for(stop);
    client_->signal(SIGCONT);
    stopped_ = now() - stoppedAt_;
  }
  /// The operator asks until a call is answered: the first time the provider may not be back yet.
  void resume() {
    const Time asked = now();
    EXPECT_TRUE(eventually([&] {
      client_->signal(SIGUSR1);
      return system_.answered(asked);
    }));
  }
  bool hasNoted(HistoryEntry::Kind kind) const { return system_.clientHasNoted(stoppedAt_, kind); }
  /// Ends all, and judges what was written down. A client is late by as long as it stood still.
  void judge() {
    EXPECT_EQ(client_->end(SIGTERM), 0);
    EXPECT_EQ(provider_->end(SIGTERM), 0);
    EXPECT_EQ(manager_->end(SIGTERM), 0);
    EXPECT_EQ(system_.lanes(), System::Lanes{lane()});
    EXPECT_TRUE(system_.haveReported());
    expectSoundHistory(system_.history(), {.lateness = kBusyMachine + stopped_});
  }

  System system_;
  const std::unique_ptr<Child> manager_ = system_.manager(), provider_ = system_.provider();
  std::unique_ptr<Child> client_;
  Time stoppedAt_{};
  Duration stopped_{0};
};

INSTANTIATE_TEST_SUITE_P(Victims, OperatorsGate,
                         testing::Combine(testing::Values(Victim::Provider, Victim::Client,
                                                          Victim::Both),
                                          testing::Values("shm", "frame", "rpc")),
                         [](const auto& test) {
                           return std::string(kVictims[static_cast<int>(std::get<0>(test.param))]) +
                                  "_" + std::get<1>(test.param);
                         });

// Commands wait at the provider for the end of the one that runs, when one of the two stops.
TEST_P(OperatorsGate, IsClosedByALoss) {
  constexpr std::chrono::milliseconds kBorne = 400ms;
  begin("operator", kBorne);
  stopInADrain(system_, *provider_);
  ASSERT_FALSE(HasFatalFailure());
  stoppedAt_ = now();
  if (victim() != Victim::Provider) client_->signal(SIGSTOP);
  if (victim() == Victim::Client) provider_->signal(SIGCONT);
  goOn(3 * kBorne / 2);
  ASSERT_TRUE(system_.clientNotes(stoppedAt_, HistoryEntry::Kind::Told));
  provider_->signal(SIGCONT);
  ASSERT_TRUE(system_.clientNotes(stoppedAt_, HistoryEntry::Kind::Connected));
  const Time back = now();
  EXPECT_TRUE(eventually([&] { return system_.callEnded(back, Errc::AwaitingOperator); }));
  EXPECT_FALSE(system_.answered(back));
  EXPECT_TRUE(hasNoted(HistoryEntry::Kind::Awaits));
  resume();
  judge();
}

// No connection is lost here. A client that alone stood still may read the newest row at once,
// before its lane has taken what waits for it, or not: then it has read nothing that is stale.
TEST_P(OperatorsGate, IsClosedByAStaleRead) {
  begin("operator-reads", 60s);
  stoppedAt_ = now();
  if (victim() != Victim::Client) provider_->signal(SIGSTOP);
  if (victim() != Victim::Provider) client_->signal(SIGSTOP);
  goOn(1500ms);
  const auto awaits = [this] { return hasNoted(HistoryEntry::Kind::Awaits); };
  ASSERT_TRUE(eventually([&] {
    return awaits() || (victim() == Victim::Client && system_.answered(stoppedAt_ + stopped_));
  }));
  provider_->signal(SIGCONT);
  const Time back = now();
  ASSERT_TRUE(system_.clientNotes(back, HistoryEntry::Kind::Heard));
  if (awaits()) {
    const Time heard = now();
    EXPECT_TRUE(eventually([&] { return system_.callEnded(heard, Errc::AwaitingOperator); }));
    EXPECT_FALSE(system_.answered(heard));
    resume();
  }
  EXPECT_FALSE(hasNoted(HistoryEntry::Kind::Told));
  judge();
}

}  // namespace
}  // namespace suture
