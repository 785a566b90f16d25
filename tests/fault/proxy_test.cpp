// A client and its provider have a proxy between them that breaks what they say, on each lane.

#include <gtest/gtest.h>

#include <functional>
#include <thread>

#include "fault/forwarder.h"
#include "fault/system.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using Mode = ByteProxy::Mode;
using Strike = ByteProxy::Strike;
using Kind = HistoryEntry::Kind;

class Proxy : public testing::TestWithParam<const char*> {
 protected:
  static constexpr int kSilenceMilliseconds = 300;

  Proxy() { EXPECT_EQ(client_->line(), "ready"); }

  std::string lane() const { return GetParam(); }
  ByteProxy& proxy() { return *forwarder_.proxy; }
  /// Only a Unix socket carries the memory of `shm`; over one, `frame` would not go through the
  /// proxy.
  net::Address proxysAddress() const {
    return net::Address::parse(lane() == "shm" ? "unix:" + system_.file("proxy.sock")
                                               : "tcp://127.0.0.1:0");
  }
  /// Returns when the client has lost a connection, or has come back since.
  void awaitLoss(Time since) const {
    ASSERT_TRUE(eventually([&] {
      return system_.clientHasNoted(since, Kind::Told) ||
             system_.clientHasNoted(since, Kind::Connected);
    }));
  }
  /// Breaks the connection again and again, and expects that it works again after each time.
  void breakAndMend(const std::function<void()>& breaks) {
    for (int round = 0; round < faultRounds(); ++round) {
      ASSERT_TRUE(system_.works(true)) << round;
      breaks();
      ASSERT_FALSE(HasFatalFailure());
      proxy().set(Mode::Forward);
    }
    expectSound();
  }
  void strike(Strike strike) {
    breakAndMend([this, strike] {
      const Time struck = now();
      proxy().strike(strike);
      awaitLoss(struck);
    });
  }
  /// Holds the connection up until an attempt of the client to come back has come to nothing.
  void holdUp(Mode mode) {
    breakAndMend([this, mode] {
      proxy().set(mode);
      ASSERT_TRUE(system_.clientIsCutOff());
      const auto hurt = proxy().injected();
      ASSERT_TRUE(eventually([&] { return proxy().injected() > hurt; }));
    });
  }
  void end() {
    EXPECT_TRUE(system_.works(true));
    EXPECT_EQ(client_->end(SIGTERM), 0);
    EXPECT_EQ(provider_->end(SIGTERM), 0);
    EXPECT_GT(proxy().injected(), 0u);
    EXPECT_EQ(system_.lanes(), System::Lanes{lane()});
    EXPECT_TRUE(system_.haveReported());
    std::printf("seed %u: %d faults, %zu entries\n", faultSeed(),
                static_cast<int>(proxy().injected()), system_.history().size());
  }
  void expectSound() {
    end();
    // On `shm` a word in shared memory tells the provider of a broken link. On other lanes only the
    // end of its lease does.
    const Duration unheard =
        lane() == "shm" ? 0ms : std::chrono::milliseconds(kSilenceMilliseconds);
    expectSoundHistory(system_.history(), {.lateness = kBusyMachine, .unheard = unheard});
  }

  System system_;
  std::unique_ptr<Child> manager_ = system_.manager(), provider_ = system_.provider("behind");
  Forwarder forwarder_{system_.address(), "robot", "behind", proxysAddress(), faultSeed()};
  std::unique_ptr<Child> client_ = [this] {
    auto child = system_.client("busy", kSilenceMilliseconds, GetParam());
    EXPECT_EQ(child->line(), "begun");
    return child;
  }();
};

INSTANTIATE_TEST_SUITE_P(Lanes, Proxy, testing::Values("shm", "frame", "rpc"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(Proxy, ClosesTheConnectionsThatItCarries) { strike(Strike::Cut); }

TEST_P(Proxy, ResetsTheConnectionsThatItCarries) { strike(Strike::Reset); }

TEST_P(Proxy, PassesHalfAMessageAndCloses) { strike(Strike::Truncate); }

TEST_P(Proxy, PassesNothingEitherWay) { holdUp(Mode::HalfOpen); }

TEST_P(Proxy, PassesOnlyWhatTheClientSays) { holdUp(Mode::OnlyThere); }

TEST_P(Proxy, PassesOnlyWhatTheClientIsTold) { holdUp(Mode::OnlyBack); }

// A trickle may be enough for the client to stay connected, so it need not be told of a loss.
TEST_P(Proxy, PassesATrickle) {
  breakAndMend([this] {
    const auto before = proxy().injected();
    const Time throttled = now();
    proxy().set(Mode::Throttle);
    ASSERT_TRUE(eventually([&] {
      return proxy().injected() > before &&
             (system_.answered(throttled) || system_.clientHasNoted(throttled, Kind::Told));
    }));
  });
}

TEST_P(Proxy, ComesAndGoesAtRandom) {
  std::mt19937 random(faultSeed());
  std::uniform_int_distribution<int> milliseconds(0, 120);
  breakAndMend([&] {
    for (int i = 0; i < 10; ++i) {
      proxy().set(i % 2 == 0 ? Mode::HalfOpen : Mode::Forward);
      if (i % 3 == 0) proxy().strike(Strike::Cut);
      std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds(random)));
    }
  });
}

// Bytes that are under way on a lost connection arrive after another has taken its place.
TEST_P(Proxy, PassesStrandedBytesLate) {
  breakAndMend([this] {
    const Time stranded = now();
    proxy().strike(Strike::Strand);
    awaitLoss(stranded);
    ASSERT_TRUE(system_.works(true));
  });
}

// Nothing checks the bytes that `rpc` carries, so a wrong bit may make another command of one.
// Whatever it has become, what follows must arrive.
TEST_P(Proxy, FlipsABit) {
  for (int flip = 0; flip < 10 * faultRounds(); ++flip) {
    ASSERT_TRUE(system_.works(true)) << flip;
    const auto before = proxy().injected();
    proxy().strike(Strike::BitFlip);
    ASSERT_TRUE(eventually([&] { return proxy().injected() > before; })) << flip;
  }
  proxy().strike(Strike::Cut);
  lane() == "rpc" ? end() : expectSound();
}

}  // namespace
}  // namespace suture
