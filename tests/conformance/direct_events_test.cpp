// These handlers run in the emitter's thread, where both ends share a process.
#include "conformance/setup.h"
#include "support/patience.h"

namespace conformance {
namespace {

using namespace std::chrono_literals;
using suture::Errc;
using suture::kPatience;

class DirectEvents : public Conformance {
 protected:
  void emitStop() {
    arm->emitSoon([](Ports ports) { ports.arm.emit().stopped(); });
  }
  /// Lets what arrives be handled until `enough` says so.
  bool await(const std::function<bool()>& enough) {
    return suture::eventually([&] {
      client->await([](const Received&) { return true; });
      return enough();
    });
  }

  std::atomic<pid_t> handledIn{0};
  std::atomic<int> handled{0};
};
/// The provider runs them itself.
class LentHandlers : public DirectEvents {};
/// Runs where no throw ends in the test's own thread, as it would where that is the client's.
class ThrowingDirectEvents : public DirectEvents {};

TEST_P(DirectEvents, TheyRunInTheEmittersThread) {
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.on().stopped.direct([&] {
      handledIn = gettid();
      ++handled;
    }));
  });
  settle();
  emitStop();
  ASSERT_TRUE(await([&] { return handled == 1 && arm->emitted() == 1; }));
  pid_t clients = 0;
  client->with([&](Arm&) { clients = gettid(); });
  EXPECT_EQ(handledIn, GetParam().isDirect()
                           ? arm->at([](ArmComponent& one) { return one.emittedIn(); })
                           : clients);
}

TEST_P(LentHandlers, TheyWaitOnlyForTheEmitter) {
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.on().arrived.direct(
        [&](const PoseStamped& pose) { handled = static_cast<int>(pose.pose.translation().x()); }));
    EXPECT_TRUE(remote.hold.start().within(kPatience));
    arm->emitSoon([&](Ports ports) {
      EXPECT_TRUE(ports.arm.emit().arrived(poseAt(7)));
      EXPECT_EQ(handled, 7) << "emit() returned before its handler";
    });
    // Each answer is a cycle of the provider's, in which it may emit.
    for (int i = 0; i < 100 && arm->emitted() == 0; ++i) {
      EXPECT_TRUE(remote.hold.start().within(kPatience));
    }
    EXPECT_EQ(arm->emitted(), 1) << "the client does not look";
  });
}

TEST_P(ThrowingDirectEvents, AThrowParksTheSubscriberAlone) {
  client->with([](Arm& remote) {
    EXPECT_TRUE(remote.on().stopped.direct([] { throw std::runtime_error("no room"); }));
  });
  settle();
  emitStop();
  EXPECT_TRUE(suture::eventually(
      [&] { return client->component().state() == suture::ComponentState::Faulted; }));
  EXPECT_EQ(client->component().fault(), "no room");
  EXPECT_TRUE(suture::eventually([&] { return arm->emitted() == 1; }));
  EXPECT_EQ(arm->state(), suture::ComponentState::Running);
}

TEST_P(DirectEvents, NoHandlerRunsAfterReset) {
  client->with([&](Arm& remote) { EXPECT_TRUE(remote.on().stopped.direct([&] { ++handled; })); });
  settle();
  emitStop();
  ASSERT_TRUE(await([&] { return handled == 1 && arm->emitted() == 1; }));
  client->with([](Arm& remote) { EXPECT_TRUE(remote.on().stopped.reset()); });
  emitStop();
  ASSERT_TRUE(await([&] { return arm->emitted() == 2; }));
  settle();
  EXPECT_EQ(handled, 1);
}

TEST_P(DirectEvents, AQueuedHandlerTakesItsPlace) {
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.on().stopped.direct([&] { handled += 100; }));
    EXPECT_TRUE(remote.hold.start().within(kPatience));
    EXPECT_TRUE(remote.on().stopped([&] {
      handledIn = gettid();
      ++handled;
    }));
  });
  emitStop();
  ASSERT_TRUE(await([&] { return handled != 0; }));
  pid_t clients = 0;
  client->with([&](Arm&) { clients = gettid(); });
  EXPECT_EQ(handled, 1);
  EXPECT_EQ(handledIn, clients);
}

TEST_P(DirectEvents, ALatchedValueIsReplayed) {
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.on().mode.reset());
    EXPECT_TRUE(remote.hold.start().within(kPatience));
  });
  arm->emitSoon([](Ports ports) { EXPECT_TRUE(ports.arm.emit().mode(Mode::Enabled)); });
  ASSERT_TRUE(await([&] { return arm->emitted() == 1; }));
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.on().mode.direct([&](const Mode& mode) {
      EXPECT_EQ(mode, Mode::Enabled);
      ++handled;
    }));
  });
  EXPECT_TRUE(await([&] { return handled == 1; }));
}

TEST_P(DirectEvents, ASuspendedSubscriberHandlesThemWhenResumed) {
  client->with([&](Arm& remote) { EXPECT_TRUE(remote.on().stopped.direct([&] { ++handled; })); });
  settle();
  client->component().request(suture::Transition::Suspend);
  ASSERT_TRUE(suture::eventually(
      [&] { return client->component().state() == suture::ComponentState::Suspended; }));
  emitStop();
  ASSERT_TRUE(suture::eventually([&] { return arm->emitted() == 1; }));
  EXPECT_EQ(handled, 0);
  client->component().request(suture::Transition::Resume);
  EXPECT_TRUE(await([&] { return handled == 1; }));
}

TEST_P(DirectEvents, ADirectHandlerKeepsNoClientWaiting) {
  client->with([&](Arm& remote) {
    auto armed = remote.on().stopped.next();
    EXPECT_TRUE(remote.on().stopped.direct([] {}));
    const Errc error = GetParam().isDirect() ? Errc::CannotWait : Errc::Timeout;
    EXPECT_EQ(armed.within(10ms).error(), error);
    EXPECT_EQ(remote.on().stopped.next().within(10ms).error(), error);
  });
}

INSTANTIATE_TEST_SUITE_P(Lanes, DirectEvents, testing::ValuesIn(laneRows()), nameOf);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(LentHandlers);  // over a lane that was added
INSTANTIATE_TEST_SUITE_P(Lanes, LentHandlers, testing::ValuesIn(laneRows(&Row::isDirect)), nameOf);
INSTANTIATE_TEST_SUITE_P(Lanes, ThrowingDirectEvents,
                         testing::ValuesIn(laneRows([](const Row& row) {
                           return row.isDirect() || row.client == ClientKind::Task;
                         })),
                         nameOf);

}  // namespace
}  // namespace conformance
