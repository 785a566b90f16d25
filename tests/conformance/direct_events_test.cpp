// Handlers that run in the thread of whoever emits, where both ends share a process.
#include "conformance/setup.h"

namespace conformance {
namespace {

using namespace std::chrono_literals;
using suture::Errc;

class DirectEvents : public Conformance {
 protected:
  bool isLocal() const { return std::get<0>(GetParam()) == LaneUnderTest::Local; }
  /// In the provider's thread; `emittedIn` tells which.
  void emitStop() {
    arm->emitSoon([this](Ports ports) {
      emittedIn = std::this_thread::get_id();
      ports.arm.emit().stopped();
      ++emitted;
    });
  }
  /// The provider knows what the client did last.
  void settle() {
    client->with([](Arm& remote) { EXPECT_TRUE(remote.hold.start().within(5s)); });
  }
  /// Lets what arrives be handled until `enough` says so.
  bool await(const std::function<bool()>& enough) {
    return suture::eventually([&] {
      client->await([](const Received&) { return true; });
      return enough();
    });
  }

  std::atomic<std::thread::id> emittedIn, handledIn;
  std::atomic<int> emitted{0}, handled{0};
};

TEST_P(DirectEvents, TheyRunInTheEmittersThread) {
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.on().stopped.direct([&] {
      handledIn = std::this_thread::get_id();
      ++handled;
    }));
  });
  settle();
  emitStop();
  ASSERT_TRUE(await([&] { return handled == 1 && emitted == 1; }));
  std::thread::id clients;
  client->with([&](Arm&) { clients = std::this_thread::get_id(); });
  EXPECT_EQ(handledIn, isLocal() ? emittedIn.load() : clients);
}

TEST_P(DirectEvents, TheyWaitForNobodyButTheEmitter) {
  if (!isLocal()) return;
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.on().arrived.direct(
        [&](const PoseStamped& pose) { handled = static_cast<int>(pose.pose.translation().x()); }));
    EXPECT_TRUE(remote.hold.start().within(5s));
    arm->emitSoon([&](Ports ports) {
      EXPECT_TRUE(ports.arm.emit().arrived(poseAt(7)));
      EXPECT_EQ(handled, 7) << "emit() returned before its handler";
      ++emitted;
    });
    EXPECT_TRUE(suture::eventually([&] { return emitted == 1; })) << "the client does not look";
  });
}

TEST_P(DirectEvents, AThrowParksTheSubscriberAlone) {
  client->with([](Arm& remote) {
    EXPECT_TRUE(remote.on().stopped.direct([] { throw std::runtime_error("no room"); }));
  });
  settle();
  if (!isLocal() && std::get<2>(GetParam()) == ClientKind::Device) return;  // its thread's to catch
  emitStop();
  EXPECT_TRUE(suture::eventually(
      [&] { return client->component().state() == suture::ComponentState::Faulted; }));
  EXPECT_EQ(client->component().fault(), "no room");
  EXPECT_TRUE(suture::eventually([&] { return emitted == 1; }));
  EXPECT_EQ(arm->component().state(), suture::ComponentState::Running);
}

TEST_P(DirectEvents, NoneRunsAfterReset) {
  client->with([&](Arm& remote) { EXPECT_TRUE(remote.on().stopped.direct([&] { ++handled; })); });
  settle();
  emitStop();
  ASSERT_TRUE(await([&] { return handled == 1 && emitted == 1; }));
  client->with([](Arm& remote) { EXPECT_TRUE(remote.on().stopped.reset()); });
  emitStop();
  ASSERT_TRUE(await([&] { return emitted == 2; }));
  settle();
  EXPECT_EQ(handled, 1);
}

TEST_P(DirectEvents, AQueuedHandlerTakesItsPlace) {
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.on().stopped.direct([&] { handled += 100; }));
    EXPECT_TRUE(remote.hold.start().within(5s));
    EXPECT_TRUE(remote.on().stopped([&] {
      handledIn = std::this_thread::get_id();
      ++handled;
    }));
  });
  emitStop();
  ASSERT_TRUE(await([&] { return handled != 0; }));
  std::thread::id clients;
  client->with([&](Arm&) { clients = std::this_thread::get_id(); });
  EXPECT_EQ(handled, 1);
  EXPECT_EQ(handledIn, clients);
}

TEST_P(DirectEvents, ALatchedValueIsReplayed) {
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.on().mode.reset());
    EXPECT_TRUE(remote.hold.start().within(5s));
  });
  arm->emitSoon([&](Ports ports) {
    EXPECT_TRUE(ports.arm.emit().mode(Mode::Enabled));
    ++emitted;
  });
  ASSERT_TRUE(await([&] { return emitted == 1; }));
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.on().mode.direct([&](const Mode& mode) {
      EXPECT_EQ(mode, Mode::Enabled);
      ++handled;
    }));
  });
  EXPECT_TRUE(await([&] { return handled == 1; }));
}

TEST_P(DirectEvents, ASuspendedSubscriberHandlesThemWhenItIsResumed) {
  client->with([&](Arm& remote) { EXPECT_TRUE(remote.on().stopped.direct([&] { ++handled; })); });
  settle();
  client->component().request(suture::Transition::Suspend);
  ASSERT_TRUE(suture::eventually(
      [&] { return client->component().state() == suture::ComponentState::Suspended; }));
  emitStop();
  ASSERT_TRUE(suture::eventually([&] { return emitted == 1; }));
  EXPECT_EQ(handled, 0);
  client->component().request(suture::Transition::Resume);
  EXPECT_TRUE(await([&] { return handled == 1; }));
}

TEST_P(DirectEvents, WhoHasADirectHandlerDoesNotWait) {
  client->with([&](Arm& remote) {
    auto armed = remote.on().stopped.next();
    EXPECT_TRUE(remote.on().stopped.direct([] {}));
    const Errc error = isLocal() ? Errc::CannotWait : Errc::Timeout;
    EXPECT_EQ(armed.within(10ms).error(), error);
    EXPECT_EQ(remote.on().stopped.next().within(10ms).error(), error);
  });
}

INSTANTIATE_TEST_SUITE_P(Lanes, DirectEvents, allCombinations(), nameOf);

}  // namespace
}  // namespace conformance
