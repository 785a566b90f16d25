// Whole processes of a system stand still (SIGSTOP) and go on, on each lane: at any moment, and
// while the provider is in the middle of a drain.

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <tuple>

#include "fault/still/drain.h"
#include "fault/system.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

// It is longer than a connection bears. It is a time, since nothing but the clock can tell how long
// a client has stood still.
constexpr Duration kStopped = 600ms;
// A provider runs so long before its client does.
constexpr Duration kAlone = 50ms;

enum class Stopped { Manager, Provider, Client, BothProviderFirst, BothClientFirst };
enum class Moment { Any, InADrain };

/// A row says what stands still, when, and which of two goes on first.
struct Row {
  const char* name;
  Stopped stopped;
  Moment moment;
};

const Row kRows[] = {
    {"Manager", Stopped::Manager, Moment::Any},
    {"Provider", Stopped::Provider, Moment::Any},
    {"Client", Stopped::Client, Moment::Any},
    {"BothThenProviderFirst", Stopped::BothProviderFirst, Moment::Any},
    {"BothThenClientFirst", Stopped::BothClientFirst, Moment::Any},
    {"ProviderInADrain", Stopped::Provider, Moment::InADrain},
    {"ClientInADrain", Stopped::Client, Moment::InADrain},
    {"BothInADrainThenProviderFirst", Stopped::BothProviderFirst, Moment::InADrain},
    {"BothInADrainThenClientFirst", Stopped::BothClientFirst, Moment::InADrain},
};

class Stop : public testing::TestWithParam<std::tuple<Row, const char*>> {
 protected:
  // A connection bears so much.
  static constexpr int kSilenceMilliseconds = 400;

  void SetUp() override {
    ASSERT_EQ(provider_->line(), "ready");
    client_ = system_.client(row().moment == Moment::InADrain ? "bursts" : "busy",
                             kSilenceMilliseconds, lane());
    ASSERT_EQ(client_->line(), "begun");
    ASSERT_EQ(client_->line(), "ready");
  }

  const Row& row() const { return std::get<0>(GetParam()); }
  const char* lane() const { return std::get<1>(GetParam()); }
  bool both() const { return row().stopped >= Stopped::BothProviderFirst; }

  void stopAnyTime() {
    std::this_thread::sleep_for(
        std::chrono::microseconds(std::uniform_int_distribution<int>(0, 20'000)(random_)));
    if (row().stopped == Stopped::Manager) manager_->signal(SIGSTOP);
    if (row().stopped == Stopped::Provider || both()) provider_->signal(SIGSTOP);
    if (row().stopped == Stopped::Client || both()) client_->signal(SIGSTOP);
  }
  void stopInItsDrain() {
    stopInADrain(system_, *provider_);
    if (row().stopped != Stopped::Provider) client_->signal(SIGSTOP);
    if (row().stopped == Stopped::Client) provider_->signal(SIGCONT);
  }
  /// Waits so long that the connection is lost, if that can be: a client that runs is told so
  /// before its provider goes on.
  void goOn() {
    if (row().stopped != Stopped::Provider) std::this_thread::sleep_for(kStopped);
    if (row().stopped == Stopped::Manager) return manager_->signal(SIGCONT);
    if (row().stopped == Stopped::BothProviderFirst) {
      provider_->signal(SIGCONT);
      std::this_thread::sleep_for(kAlone);
    }
    client_->signal(SIGCONT);
    if (row().stopped == Stopped::Provider || row().stopped == Stopped::BothClientFirst) {
      EXPECT_TRUE(system_.clientIsCutOff());
    }
    provider_->signal(SIGCONT);
  }

  System system_;
  std::mt19937 random_{faultSeed()};
  const std::unique_ptr<Child> manager_ = system_.manager(), provider_ = system_.provider();
  std::unique_ptr<Child> client_;
};

INSTANTIATE_TEST_SUITE_P(
    Rows, Stop, testing::Combine(testing::ValuesIn(kRows), testing::Values("shm", "frame", "rpc")),
    [](const auto& test) {
      return std::string(std::get<0>(test.param).name) + "_" + std::get<1>(test.param);
    });

TEST_P(Stop, LeavesSoundHistories) {
  int stops = 0;
  for (; stops < faultRounds(); ++stops) {
    ASSERT_TRUE(system_.works(true));
    row().moment == Moment::InADrain ? stopInItsDrain() : stopAnyTime();
    ASSERT_FALSE(HasFatalFailure());
    goOn();
  }
  EXPECT_TRUE(system_.works(true));
  EXPECT_EQ(client_->end(SIGTERM), 0);
  EXPECT_EQ(provider_->end(SIGTERM), 0);
  EXPECT_EQ(manager_->end(SIGTERM), 0);
  EXPECT_EQ(system_.lanes(), System::Lanes{lane()});
  EXPECT_TRUE(system_.haveReported());
  // A client that stands still is late.
  expectSoundHistory(system_.history(), {.lateness = kBusyMachine + kStopped});
  std::printf("seed %u: %d stops, %zu entries\n", faultSeed(), stops, system_.history().size());
  EXPECT_GT(stops, 0);
}

}  // namespace
}  // namespace suture
