// Calls are taken back, and calls say themselves when they have ended.
#include <optional>

#include "conformance/setup.h"
#include "support/patience.h"

namespace conformance {
namespace {

using namespace std::chrono_literals;
using suture::Errc;
using suture::kPatience;
using suture::Result;

class Calls : public Conformance {};
/// The provider does not execute them before start() returns.
class QueuedCalls : public Conformance {};

TEST_P(QueuedCalls, OnlyACancelledCallIsNotExecuted) {
  bool cancelled = false;
  stall();
  client->with([&](Arm& remote) {
    auto call = remote.move.start(poseAt(1), 1, "");
    cancelled = call.cancel();
    ASSERT_EQ(call.poll() != nullptr, cancelled);
    if (cancelled) {
      EXPECT_EQ(call.poll()->error(), Errc::Cancelled);
    }
    EXPECT_FALSE(cancelled && call.cancel()) << "it has ended";
    EXPECT_TRUE(cancelled || !GetParam().isDirect());
  });
  arm->gate().open();
  client->with(
      [](Arm& remote) { EXPECT_TRUE(remote.limit.start(1, Mode::Enabled).within(kPatience)); });
  std::vector<std::string> expected = {"disable", "servo_cp 1", "move 100% ", "limit 1 enabled"};
  if (cancelled) expected.erase(expected.begin() + 1, expected.begin() + 3);
  EXPECT_EQ(arm->taken(), expected);
}

TEST_P(QueuedCalls, ARunningCallCannotBeCancelled) {
  using Moved = decltype(std::declval<Arm&>().move.start(poseAt(1), 1, ""));
  std::optional<Moved> call;
  arm->gate().close();
  client->with([&](Arm& remote) { call.emplace(remote.move.start(poseAt(1), 1, "wait")); });
  ASSERT_TRUE(suture::eventually([&] { return arm->gate().hasVisitor(); }));
  client->with([&](Arm&) {
    EXPECT_FALSE(call->cancel());
    EXPECT_FALSE(call->poll());
    arm->gate().open();
    EXPECT_TRUE(call->within(kPatience));
    EXPECT_FALSE(call->cancel());
    call.reset();
  });
}

TEST_P(QueuedCalls, CancelledOnesGiveTheirPlacesBack) {
  for (int i = 0; i < 40; ++i) {  // more than can be under way
    client->with([](Arm& remote) {
      auto call = remote.hold.start();
      EXPECT_TRUE(call.cancel() || call.within(kPatience));
      EXPECT_TRUE(remote.limit.start(1, Mode::Enabled).within(kPatience));
    });
  }
}

TEST_P(Calls, AHandlerGetsTheAnswer) {
  struct Ends {
    int held = 0, moved = 0;
    bool reached = false;
  } ends;
  client->with([&ends](Arm& remote) {
    remote.hold.start().then([&ends](const Result<void>& end) { ends.held += end ? 1 : 100; });
    remote.move.start(poseAt(1), 0.75, "").then([&ends](const Result<bool>& reached) {
      ++ends.moved;
      ends.reached = reached && *reached;
    });
  });
  EXPECT_TRUE(client->await([&](const Received&) { return ends.held > 0 && ends.moved > 0; }));
  client->with([&ends](Arm&) {
    EXPECT_EQ(ends.held, 1);
    EXPECT_EQ(ends.moved, 1);
    EXPECT_TRUE(ends.reached);
  });
}

TEST_P(Calls, AHandlerMayStartTheNext) {
  struct Chain {
    Arm* remote = nullptr;
    std::atomic<int> ended{0};
    void next() {
      remote->hold.start().then([this](const Result<void>& end) {
        EXPECT_TRUE(end);
        if (++ended < 40) next();  // more than can be under way
      });
    }
  } chain;
  client->with([&chain](Arm& remote) {
    chain.remote = &remote;
    chain.next();
  });
  EXPECT_TRUE(client->await([&](const Received&) { return chain.ended == 40; }));
}

INSTANTIATE_TEST_SUITE_P(Lanes, Calls, testing::ValuesIn(laneRows()), nameOf);
INSTANTIATE_TEST_SUITE_P(Lanes, QueuedCalls, testing::ValuesIn(laneRows(isQueued)), nameOf);

}  // namespace
}  // namespace conformance
