// Calls that are taken back, and calls that say themselves when they have ended.
#include "conformance/setup.h"

namespace conformance {
namespace {

using namespace std::chrono_literals;
using suture::Errc;
using suture::Result;

class Calls : public Conformance {
 protected:
  /// Runs `work` in the client's thread while the provider, a task or elsewhere, sits in a handler.
  void whileBusy(const std::function<void(Arm&)>& work) {
    arm->gate().close();
    client->with([&](Arm& remote) {
      EXPECT_TRUE(remote.set_mode(Mode::Disabled));
      remote.owner().ringNow();
      arm->gate().awaitVisitor();
      work(remote);
    });
    arm->gate().open();
  }
};

TEST_P(Calls, ACancelledOneIsNeverExecutedAndAnyOtherIs) {
  if (runsInCallersThread()) return;  // has been executed when start() returns
  bool cancelled = false;
  whileBusy([&](Arm& remote) {
    auto call = remote.move.start(poseAt(1), 1, "");
    cancelled = call.cancel();
    ASSERT_EQ(call.poll() != nullptr, cancelled);
    if (cancelled) {
      EXPECT_EQ(call.poll()->error(), Errc::Cancelled);
    }
    EXPECT_FALSE(cancelled && call.cancel()) << "it has ended";
    EXPECT_TRUE(cancelled || std::get<0>(GetParam()) != LaneUnderTest::Local);
  });
  client->with([](Arm& remote) { EXPECT_TRUE(remote.limit.start(1, Mode::Enabled).within(5s)); });
  std::vector<std::string> expected = {"disable", "servo_cp 1", "move 100% ", "limit 1 enabled"};
  if (cancelled) expected.erase(expected.begin() + 1, expected.begin() + 3);
  EXPECT_EQ(arm->taken(), expected);
}

TEST_P(Calls, OneThatIsBeingExecutedCannotBeCancelled) {
  if (runsInCallersThread()) return;  // start() returns behind the gate
  arm->gate().close();
  client->with([&](Arm& remote) {
    auto call = remote.move.start(poseAt(1), 1, "wait");
    remote.owner().ringNow();
    arm->gate().awaitVisitor();
    EXPECT_FALSE(call.cancel());
    EXPECT_FALSE(call.poll());
    arm->gate().open();
    EXPECT_TRUE(call.within(5s));
    EXPECT_FALSE(call.cancel());
  });
}

TEST_P(Calls, CancelledOnesGiveTheirPlacesBack) {
  if (runsInCallersThread()) return;
  for (int i = 0; i < 40; ++i) {  // more than can be under way
    client->with([](Arm& remote) {
      auto call = remote.hold.start();
      EXPECT_TRUE(call.cancel() || call.within(5s));
      EXPECT_TRUE(remote.limit.start(1, Mode::Enabled).within(5s));
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

INSTANTIATE_TEST_SUITE_P(Lanes, Calls, testing::ValuesIn(allCombinations()), nameOf);

}  // namespace
}  // namespace conformance
