// These wait for one event.
#include <suture/component/channel/channel.h>

#include <optional>

#include "conformance/setup.h"
#include "support/patience.h"
#include "support/test_thread.h"

namespace conformance {
namespace {

using namespace std::chrono_literals;
using suture::Errc;
using suture::kPatience;

class NextEvents : public Conformance {
 protected:
  void emitArrival(double x) {
    arm->emitSoon([x](Ports ports) { EXPECT_TRUE(ports.arm.emit().arrived(poseAt(x))); });
  }
  void emitStop() {
    arm->emitSoon([](Ports ports) { ports.arm.emit().stopped(); });
  }
};
/// The provider has a life of its own: it can end while the client lives.
class LastEvents : public NextEvents {};

double placeOf(const PoseStamped& pose) { return pose.pose.translation().x(); }

TEST_P(NextEvents, MayHaveNoPayload) {
  client->with([&](Arm& remote) {
    auto stopped = remote.on().stopped.next();
    EXPECT_FALSE(stopped.poll());
    emitStop();
    EXPECT_TRUE(stopped.within(kPatience));
    EXPECT_TRUE(*stopped.poll());
  });
}

TEST_P(NextEvents, HaveOneValueOrSeveral) {
  client->with([&](Arm& remote) {
    auto arrived = remote.on().arrived.next();
    auto moved = remote.on().moved.next();
    emitArrival(4);
    arm->emitSoon([](Ports ports) { EXPECT_TRUE(ports.arm.emit().moved(poseAt(5), 0.25)); });
    const auto both = moved.within(kPatience);
    ASSERT_TRUE(both);
    EXPECT_EQ(placeOf(std::get<0>(*both)), 5);
    EXPECT_EQ(std::get<1>(*both), 0.25);
    ASSERT_TRUE(arrived.poll() && *arrived.poll()) << "it came while the other was awaited";
    EXPECT_EQ(placeOf(**arrived.poll()), 4);
  });
}

TEST_P(NextEvents, QueuedEventsAreHandledAndNotAwaited) {
  client->with([&](Arm& remote) {
    emitArrival(1);
    ASSERT_TRUE(awaitInPlace(remote, [&] { return channel()->events.pending(); }));
    suture::pass(1us);  // or the first would be as new as the wait for the next
    auto arrived = remote.on().arrived.next();
    emitArrival(2);
    const auto place = arrived.within(kPatience);
    ASSERT_TRUE(place);
    EXPECT_EQ(placeOf(*place), 2);
  });
  EXPECT_TRUE(client->await([](const Received& received) {
    return received.arrivals == std::vector<double>{1, 2};
  }));
}

TEST_P(NextEvents, NeedsNoHandler) {
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.on().arrived.reset());
    for (int round = 1; round <= 5; ++round) {
      auto arrived = remote.on().arrived.next();
      EXPECT_TRUE(remote.hold.start().within(kPatience)) << "by then the provider knows";
      emitArrival(round);
      const auto place = arrived.within(kPatience);
      ASSERT_TRUE(place);
      EXPECT_EQ(placeOf(*place), round);
    }
  });
}

TEST_P(NextEvents, AReplayIsNotCounted) {
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.on().mode.reset());
    auto stopped = remote.on().stopped.next();
    arm->emitSoon([](Ports ports) {
      EXPECT_TRUE(ports.arm.emit().mode(Mode::Disabled));
      ports.arm.emit().stopped();
    });
    ASSERT_TRUE(stopped.within(kPatience));
    suture::pass(1us);  // or the replay would be as new as the wait for the next
    auto changed = remote.on().mode.next();
    ASSERT_TRUE(awaitInPlace(remote, [&] { return channel()->events.pending(); })) << "the replay";
    EXPECT_EQ(remote.on().mode.next().within(1ms).error(), Errc::Timeout);
    EXPECT_FALSE(changed.poll());
    arm->emitSoon([](Ports ports) { EXPECT_TRUE(ports.arm.emit().mode(Mode::Enabled)); });
    const auto mode = changed.within(kPatience);
    ASSERT_TRUE(mode);
    EXPECT_EQ(*mode, Mode::Enabled);
  });
}

TEST_P(NextEvents, AControlLoopLooks) {
  using Stopped = decltype(std::declval<Arm&>().on().stopped.next());
  std::optional<Stopped> stopped;
  client->with([&](Arm& remote) {
    Stopped armed = remote.on().stopped.next();
    stopped.emplace(std::move(armed));
    EXPECT_FALSE(stopped->poll());
  });
  emitStop();
  EXPECT_TRUE(client->await([&](const Received&) { return stopped->poll() != nullptr; }));
  client->with([&](Arm&) {
    EXPECT_TRUE(*stopped->poll());
    stopped.reset();
  });
}

TEST_P(NextEvents, TheWaitEndsAtItsLimit) {
  client->with([](Arm& remote) {
    const auto begin = suture::now();
    EXPECT_EQ(remote.on().stopped.next().within(20ms).error(), Errc::Timeout);
    EXPECT_GE(suture::now() - begin, 20ms);
  });
}

TEST_P(LastEvents, TheWaitEndsWithTheProvider) {
  client->with([&](Arm& remote) {
    auto stopped = remote.on().stopped.next();
    suture::TestThread ender([&] { stopProvider(); });
    EXPECT_EQ(stopped.within(kPatience).error(), Errc::Lost);
    ender.join();
    EXPECT_EQ(remote.on().stopped.next().within(kPatience).error(), Errc::Lost);
  });
}

TEST_P(NextEvents, AHandlerCannotWait) {
  std::vector<Errc> errors;
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.on().stopped([&errors, &remote] {
      errors.push_back(remote.on().arrived.next().within(kPatience).error());
    }));
    auto stopped = remote.on().stopped.next();
    emitStop();
    EXPECT_TRUE(stopped.within(kPatience));
    EXPECT_EQ(errors, std::vector<Errc>{Errc::CannotWait});
  });
}

TEST_P(NextEvents, AnotherThreadIsTurnedAway) {
  client->with([](Arm& remote) {
    EXPECT_TRUE(remote.hold());
    suture::TestThread([&remote] {
      EXPECT_EQ(remote.on().stopped.next().within(1s).error(), Errc::WrongThread);
    }).join();
  });
}

INSTANTIATE_TEST_SUITE_P(Lanes, NextEvents, testing::ValuesIn(laneRows()), nameOf);
INSTANTIATE_TEST_SUITE_P(Lanes, LastEvents, testing::ValuesIn(wireRows(&Row::providerCanEnd)),
                         nameOf);

}  // namespace
}  // namespace conformance
