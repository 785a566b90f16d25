// A client and its provider with a proxy between them that breaks what they say.

#include <gtest/gtest.h>
#include <suture/manager/manager_link.h>
#include <suture/transport/rpc/control_thread.h>

#include <algorithm>
#include <functional>
#include <thread>

#include "fault/byte_proxy.h"
#include "fault/system.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using Mode = ByteProxy::Mode;
using Strike = ByteProxy::Strike;
using Kind = HistoryEntry::Kind;

constexpr int kSilenceMilliseconds = 300;
constexpr Duration kFault = 700ms;  // longer than that, and than an attempt to come back
// The bound of every reconnection, from the end of what broke the connection.
constexpr Duration kBack = 1s;
constexpr int kRounds = 3;

/// What the global manager is told by whoever forwards a port: a name, and where it is.
class Forwarder {
 public:
  Forwarder(const std::string& manager, std::string name, std::string behind, unsigned seed) {
    control_.run(20s, [&, name, behind, address = rpc::Address::parse(manager)] {
      link_ = std::make_unique<ManagerLink>(control_, std::vector{address}, "forwarder");
      return link_->open(10s)
          .then([this, behind] { return link_->resolve(behind, 10s); })
          .then([this, name, seed](ProcessRecord found) {
            proxy = std::make_unique<ByteProxy>(rpc::Address::parse(found.addresses.at(0)), seed);
            found.name = name;
            found.addresses = {proxy->address()};
            return link_->enrol(found);
          });
    });
  }
  ~Forwarder() {
    control_.run(10s, [this] { link_.reset(); });
  }
  Forwarder(const Forwarder&) = delete;
  Forwarder& operator=(const Forwarder&) = delete;

  std::unique_ptr<ByteProxy> proxy;

 private:
  rpc::ControlThread control_;
  std::unique_ptr<ManagerLink> link_;
};

class Proxy : public testing::Test {
 protected:
  Proxy() { EXPECT_EQ(client_->line(), "ready"); }

  ByteProxy& proxy() { return *forwarder_.proxy; }
  /// When the client first was answered after that; unset: within ten seconds it was not.
  Time answeredAfter(Time then) const {
    Time first{};
    eventually([&] {
      for (const HistoryEntry& entry : system_.clientsHistory()) {
        const bool answer = entry.kind == Kind::Ended && entry.error == Errc{} && entry.id % 2 == 0;
        if (answer && entry.at > then) {
          first = entry.at;
          return true;
        }
      }
      return false;
    });
    return first;
  }
  /// Breaks it again and again, and sees how soon it is whole after each end.
  void breakAndMend(const std::function<void()>& breaks, const std::function<void()>& mends) {
    std::vector<Duration> back;
    for (int round = 0; round < kRounds; ++round) {
      ASSERT_TRUE(system_.works(true)) << round;
      breaks();
      mends();
      const Time mended = now();
      const Time answered = answeredAfter(mended);
      ASSERT_NE(answered, Time{}) << round;
      back.push_back(answered - mended);
    }
    std::sort(back.begin(), back.end());
    EXPECT_LE(back[back.size() / 2], kBack);
  }
  void breakFor(Duration fault, Mode mode) {
    breakAndMend(
        [this, mode, fault] {
          proxy().set(mode);
          std::this_thread::sleep_for(fault);
        },
        [this] { proxy().set(Mode::Forward); });
    expectSound();
  }
  void end() {
    EXPECT_TRUE(system_.works(true));
    EXPECT_EQ(client_->end(SIGTERM), 0);
    EXPECT_EQ(provider_->end(SIGTERM), 0);
    EXPECT_GT(proxy().injected(), 0u);
    std::printf("seed %u: %d faults, %zu entries\n", faultSeed(),
                static_cast<int>(proxy().injected()), system_.history().size());
  }
  void expectSound() {
    end();
    expectSoundHistory(system_.history());
  }

  System system_;
  std::unique_ptr<Child> manager_ = system_.manager(), provider_ = system_.provider("behind");
  Forwarder forwarder_{system_.address(), "robot", "behind", faultSeed()};
  std::unique_ptr<Child> client_ = [this] {
    auto child = system_.client("busy", kSilenceMilliseconds);
    EXPECT_EQ(child->line(), "begun");
    return child;
  }();
};

TEST_F(Proxy, Cut) {
  breakAndMend([this] { proxy().strike(Strike::Cut); }, [] {});
  expectSound();
}

TEST_F(Proxy, Reset) {
  breakAndMend([this] { proxy().strike(Strike::Reset); }, [] {});
  expectSound();
}

TEST_F(Proxy, Truncate) {
  breakAndMend([this] { proxy().strike(Strike::Truncate); }, [] {});
  expectSound();
}

TEST_F(Proxy, HalfOpen) { breakFor(kFault, Mode::HalfOpen); }

TEST_F(Proxy, OneWayThere) { breakFor(kFault, Mode::OnlyThere); }

TEST_F(Proxy, OneWayBack) { breakFor(kFault, Mode::OnlyBack); }

TEST_F(Proxy, Throttle) { breakFor(kFault, Mode::Throttle); }

TEST_F(Proxy, Flap) {
  std::mt19937 random(faultSeed());
  std::uniform_int_distribution<int> milliseconds(0, 120);
  breakAndMend(
      [&] {
        for (int i = 0; i < 10; ++i) {
          proxy().set(i % 2 == 0 ? Mode::HalfOpen : Mode::Forward);
          if (i % 3 == 0) proxy().strike(Strike::Cut);
          std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds(random)));
        }
      },
      [this] { proxy().set(Mode::Forward); });
  expectSound();
}

// What was under way on a connection that was lost arrives when another has taken its place.
TEST_F(Proxy, StrandedBytes) {
  for (int round = 0; round < kRounds; ++round) {
    ASSERT_TRUE(system_.works(true)) << round;
    proxy().strike(Strike::Strand);
    const Time stranded = now();
    ASSERT_NE(answeredAfter(stranded + std::chrono::milliseconds(kSilenceMilliseconds)), Time{});
    proxy().set(Mode::Forward);
  }
  expectSound();
}

// This lane has no checksum of its own: what arrives may be another command. Nobody falls over it.
TEST_F(Proxy, BitFlip) {
  for (int flip = 0; flip < 40; ++flip) {
    const auto before = proxy().injected();
    proxy().strike(Strike::BitFlip);
    ASSERT_TRUE(eventually([&] { return proxy().injected() > before; }));
  }
  proxy().strike(Strike::Cut);
  end();
}

}  // namespace
}  // namespace suture
