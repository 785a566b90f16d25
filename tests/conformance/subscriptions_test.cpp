// These subscribe and unsubscribe while both ends run.
#include <suture/component/channel/channel.h>

#include "conformance/setup.h"
#include "support/patience.h"
#include "support/test_thread.h"

namespace conformance {
namespace {

using namespace std::chrono_literals;
using suture::Errc;
using suture::kPatience;

class Subscriptions : public Conformance {
 protected:
  void emitArrival(double x) {
    arm->emitSoon([x](Ports ports) { EXPECT_TRUE(ports.arm.emit().arrived(poseAt(x))); });
  }
  /// Returns true when stopped() number `count` has come: what was emitted before has had its
  /// chance.
  bool afterStop(int count) {
    arm->emitSoon([](Ports ports) { ports.arm.emit().stopped(); });
    return client->await([count](const Received& received) { return received.stops == count; });
  }
  /// Subscribes as the first connection's handler did, into a list of the test's own.
  void listenTo(Arm& remote, std::vector<double>& arrivals) {
    EXPECT_TRUE(remote.on().arrived(
        [&arrivals](const PoseStamped& pose) { arrivals.push_back(pose.pose.translation().x()); }));
  }
  /// Reads the value in the client's thread, so that a test sees what its handlers wrote.
  template <class T>
  T seen(const T& value) {
    T copy{};
    client->with([&](Arm&) { copy = value; });
    return copy;
  }
};
class WireSubscriptions : public Subscriptions {};
/// The provider is a task: a device emits when it is told to, here by the test.
class SubscriptionsToTasks : public Subscriptions {};

TEST_P(Subscriptions, NoHandlerRunsAfterReset) {
  emitArrival(1);
  ASSERT_TRUE(afterStop(1));
  client->with([](Arm& remote) { EXPECT_TRUE(remote.on().arrived.reset()); });
  emitArrival(2);
  ASSERT_TRUE(afterStop(2));
  EXPECT_TRUE(client->await(
      [](const Received& received) { return received.arrivals == std::vector<double>{1}; }));
}

TEST_P(Subscriptions, AnUnsubscribedEventIsNotSent) {
  client->with([](Arm& remote) { EXPECT_TRUE(remote.on().arrived.reset()); });
  settle();
  const auto before = channel()->events.delivered();
  emitArrival(1);
  ASSERT_TRUE(afterStop(1));
  EXPECT_EQ(channel()->events.delivered() - before, 1u);
}

TEST_P(Subscriptions, QueuedEventsReachNoLaterHandler) {
  std::vector<double> later;
  client->with([&](Arm& remote) {
    emitArrival(1);
    ASSERT_TRUE(awaitInPlace(remote, [&] { return channel()->events.pending(); }));
    EXPECT_TRUE(remote.on().arrived.reset());
    suture::pass(std::chrono::microseconds(1));  // or the event would be as new as the handler
    listenTo(remote, later);
  });
  settle();
  emitArrival(2);
  ASSERT_TRUE(afterStop(1));
  EXPECT_EQ(seen(later), std::vector<double>{2});
}

TEST_P(SubscriptionsToTasks, AnEventOfALaterCommandArrives) {
  for (int round = 1; round <= 20; ++round) {
    std::vector<double> arrivals;
    client->with([&](Arm& remote) {
      EXPECT_TRUE(remote.on().arrived.reset());
      EXPECT_TRUE(remote.hold());
    });
    client->with([&](Arm& remote) {
      listenTo(remote, arrivals);
      EXPECT_TRUE(remote.set_mode.start(Mode::Enabled).within(kPatience));
    });
    emitArrival(round);
    ASSERT_TRUE(afterStop(round));
    ASSERT_EQ(seen(arrivals), std::vector<double>{double(round)});
    client->with([](Arm& remote) { EXPECT_TRUE(remote.on().arrived.reset()); });
  }
}

TEST_P(WireSubscriptions, ALatchedEventReachesANewSubscriber) {
  client->with([](Arm& remote) { EXPECT_TRUE(remote.on().mode.reset()); });
  arm->emitSoon([](Ports ports) {
    EXPECT_TRUE(ports.arm.emit().mode(Mode::Disabled));
    EXPECT_TRUE(ports.arm.emit().mode(Mode::Enabled));
  });
  ASSERT_TRUE(afterStop(1));
  for (int round = 0; round < 3; ++round) {
    std::vector<Mode> modes;
    client->with([&](Arm& remote) {
      EXPECT_TRUE(remote.on().mode([&](const Mode& mode) { modes.push_back(mode); }));
    });
    ASSERT_TRUE(client->await([&](const Received&) { return !modes.empty(); }));
    settle();
    EXPECT_EQ(seen(modes), std::vector<Mode>{Mode::Enabled});
    client->with([](Arm& remote) { EXPECT_TRUE(remote.on().mode.reset()); });
  }
}

TEST_P(Subscriptions, WaitingLatchedValuesReachNoLaterHandler) {
  std::vector<Mode> modes;
  client->with([&](Arm& remote) {
    arm->emitSoon([](Ports ports) { EXPECT_TRUE(ports.arm.emit().mode(Mode::Disabled)); });
    ASSERT_TRUE(awaitInPlace(remote, [&] { return channel()->events.pending(); }));
    EXPECT_TRUE(remote.on().mode.reset());
    arm->emitSoon([](Ports ports) { EXPECT_TRUE(ports.arm.emit().mode(Mode::Enabled)); });
    // The first answer may be of the cycle in which the event is emitted, and the second is not.
    for (int i = 0; i < 2; ++i) EXPECT_TRUE(remote.hold.start().within(kPatience));
    suture::pass(std::chrono::microseconds(1));  // or the event would be as new as the handler
    EXPECT_TRUE(remote.on().mode([&](const Mode& mode) { modes.push_back(mode); }));
  });
  ASSERT_TRUE(client->await([&](const Received&) { return !modes.empty(); }));
  settle();
  EXPECT_EQ(seen(modes), std::vector<Mode>{Mode::Enabled});
}

TEST_P(Subscriptions, AHandlerMayEndItsOwnSubscription) {
  int arrivals = 0;
  client->with([&](Arm& remote) {
    const std::string longer(100, 'x');
    EXPECT_TRUE(remote.on().arrived([&arrivals, &remote, longer](const PoseStamped&) {
      EXPECT_TRUE(remote.on().arrived.reset());
      arrivals += longer == std::string(100, 'x') ? 1 : 100;
    }));
  });
  emitArrival(1);
  emitArrival(2);
  ASSERT_TRUE(afterStop(1));
  EXPECT_EQ(seen(arrivals), 1);
}

TEST_P(Subscriptions, AnotherHandlerReplacesTheFirst) {
  std::vector<double> arrivals;
  client->with([&](Arm& remote) { listenTo(remote, arrivals); });
  emitArrival(1);
  ASSERT_TRUE(afterStop(1));
  EXPECT_EQ(seen(arrivals), std::vector<double>{1});
  EXPECT_TRUE(client->await([](const Received& received) { return received.arrivals.empty(); }));
}

TEST_P(Subscriptions, AnotherThreadIsTurnedAway) {
  settle();  // by now a device's interface is this thread's
  client->with([](Arm& remote) {
    suture::TestThread stranger([&remote] {
      EXPECT_EQ(remote.on().stopped([] {}).error(), Errc::WrongThread);
      EXPECT_EQ(remote.on().stopped.reset().error(), Errc::WrongThread);
      EXPECT_EQ(remote.on().arrived([](const PoseStamped&) {}).error(), Errc::WrongThread);
      EXPECT_EQ(remote.on().arrived.reset().error(), Errc::WrongThread);
    });
    stranger.join();
  });
  EXPECT_TRUE(afterStop(1));
}

INSTANTIATE_TEST_SUITE_P(Lanes, Subscriptions, testing::ValuesIn(laneRows()), nameOf);
INSTANTIATE_TEST_SUITE_P(Lanes, WireSubscriptions, testing::ValuesIn(wireRows()), nameOf);
INSTANTIATE_TEST_SUITE_P(
    Lanes, SubscriptionsToTasks,
    testing::ValuesIn(laneRows([](const Row& row) { return !row.providerIsDevice(); })), nameOf);

}  // namespace
}  // namespace conformance
