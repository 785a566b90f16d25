// A client and its provider have a proxy between them that breaks what they say, on each lane.

#include <gtest/gtest.h>
#include <suture/loop/control_thread.h>
#include <suture/names/manager_link.h>

#include <functional>
#include <thread>

#include "fault/byte_proxy.h"
#include "fault/system.h"
#include "support/patience.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using Mode = ByteProxy::Mode;
using Strike = ByteProxy::Strike;
using Kind = HistoryEntry::Kind;

/// Tells the global manager what a process that forwards a port would: a name, and where it is.
class Forwarder {
 public:
  /// Its proxy listens at `here`.
  Forwarder(const std::string& manager, const std::string& name, const std::string& behind,
            const rpc::Address& here, unsigned seed) {
    control_.run(kPatience, [&, name, behind, here, address = rpc::Address::parse(manager)] {
      link_ = std::make_unique<ManagerLink>(control_, std::vector{address}, "forwarder");
      return link_->open(kPatience)
          .then([this, behind] { return link_->resolve(behind, kPatience); })
          .then([this, name, here, seed](ProcessRecord found) {
            const auto target = rpc::Address::parse(found.addresses.at(0));
            proxy = std::make_unique<ByteProxy>(here, target, seed);
            found.name = name;
            found.addresses = {proxy->address()};
            return link_->enrol(found);
          });
    });
  }
  ~Forwarder() {
    control_.run(kPatience, [this] { link_.reset(); });
  }
  Forwarder(const Forwarder&) = delete;
  Forwarder& operator=(const Forwarder&) = delete;

  std::unique_ptr<ByteProxy> proxy;

 private:
  rpc::ControlThread control_;
  std::unique_ptr<ManagerLink> link_;
};

class Proxy : public testing::TestWithParam<const char*> {
 protected:
  static constexpr int kSilenceMilliseconds = 300;

  Proxy() { EXPECT_EQ(client_->line(), "ready"); }

  std::string lane() const { return GetParam(); }
  ByteProxy& proxy() { return *forwarder_.proxy; }
  /// Only a Unix socket carries the memory of `shm`; over one, `frame` would not go through the
  /// proxy.
  rpc::Address proxysAddress() const {
    return rpc::Address::parse(lane() == "shm" ? "unix:" + system_.file("proxy.sock")
                                               : "tcp://127.0.0.1:0");
  }
  /// Returns when the client has lost a connection, or has come back since.
  void awaitLoss(Time since) const {
    ASSERT_TRUE(eventually([&] {
      return system_.clientHasNoted(since, Kind::Told) ||
             system_.clientHasNoted(since, Kind::Connected);
    }));
  }
  /// Breaks it again and again, and sees it whole each time.
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
  /// Holds it up until an attempt to come back has come to nothing.
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
    // Where a word in shared memory does not tell the provider of a broken link, its lease does.
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

TEST_P(Proxy, Cut) { strike(Strike::Cut); }

TEST_P(Proxy, Reset) { strike(Strike::Reset); }

TEST_P(Proxy, Truncate) { strike(Strike::Truncate); }

TEST_P(Proxy, HalfOpen) { holdUp(Mode::HalfOpen); }

TEST_P(Proxy, OneWayThere) { holdUp(Mode::OnlyThere); }

TEST_P(Proxy, OneWayBack) { holdUp(Mode::OnlyBack); }

// A trickle may be enough to stay connected.
TEST_P(Proxy, Throttle) {
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

TEST_P(Proxy, Flap) {
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

// Bytes that were under way on a connection that was lost arrive when another has taken its place.
TEST_P(Proxy, StrandedBytes) {
  breakAndMend([this] {
    const Time stranded = now();
    proxy().strike(Strike::Strand);
    awaitLoss(stranded);
    ASSERT_TRUE(system_.works(true));
  });
}

// No part checks what `rpc` carries, so that what arrives may be another command. Whatever it was,
// what follows arrives.
TEST_P(Proxy, BitFlip) {
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
