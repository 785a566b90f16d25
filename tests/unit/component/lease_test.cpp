// The lease says until when a provider may execute what a client has sent.
#include <gtest/gtest.h>
#include <suture/component/channel/lease.h>

#include "support/pass.h"
#include "support/stepped.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

TEST(Lease, IsEndlessForASilentClient) {
  EXPECT_EQ(Lease().end(), BootTime::max());
  EXPECT_FALSE(Lease().lapsed(BootClock::now()));
  EXPECT_EQ(Lease(std::make_shared<PeerState>(), 0s).end(), BootTime::max());
  EXPECT_EQ(Lease(nullptr, 1s).end(), BootTime::max());
}

TEST(Lease, CountsFromItsBeginningAtFirst) {
  const auto client = std::make_shared<PeerState>();
  const BootTime before = BootClock::now();
  client->heard = before - 1h;  // on an earlier connection
  const Lease lease(client, 10s);
  EXPECT_GE(lease.end(), before + 9s);
  EXPECT_LT(lease.end(), BootClock::now() + 10s) << "it must not end behind the client's";
  EXPECT_FALSE(lease.lapsed(BootClock::now()));
}

TEST(Lease, EachConnectionsLeaseFollowsTheSession) {
  const auto client = std::make_shared<PeerState>();
  const Lease shorter(client, 1s), longer(client, 10s);
  const BootTime heard = BootClock::now() + 1h;
  client->heard = heard;
  EXPECT_EQ(shorter.end(), heard + 999ms);
  EXPECT_EQ(longer.end(), heard + 9990ms);
}

TEST(Lease, LapsesWithoutAWord) {
  const Lease lease(std::make_shared<PeerState>(), 1ms);
  pass(1ms);
  EXPECT_TRUE(lease.lapsed(BootClock::now()));
}

TEST(Lease, EndsWhileTheMachineIsSuspended) {
  const Lease lease(std::make_shared<PeerState>(), 1s);
  clockOfTest().suspend(900ms);
  EXPECT_FALSE(lease.lapsed(BootClock::now()));
  clockOfTest().suspend(100ms);
  EXPECT_TRUE(lease.lapsed(BootClock::now()));
}

}  // namespace
}  // namespace suture
