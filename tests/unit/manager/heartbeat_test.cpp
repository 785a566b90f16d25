// A heartbeat tells a silent peer and a task that hangs by what the process answers.

#include <gtest/gtest.h>
#include <suture/loop/event_port.h>
#include <suture/session/client/heartbeat.h>
#include <suture/session/task_activity.h>

#include <deque>
#include <limits>
#include <vector>

#include "support/stepped.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

constexpr Heartbeat::Bounds kBounds{.silence = 5s, .hang = 100ms};

/// Holds what a process tells of its task "Arm": one answer after the other, the last again and
/// again. Any other task is in time.
struct Answers {
  std::vector<Duration> overdue;
  unsigned silentAfter = std::numeric_limits<unsigned>::max();
  unsigned asked = 0;
  Duration sleep{0};      // the machine is suspended for so long when it is asked
  std::size_t named = 0;  // lists of components that it has been told
  std::vector<std::string> components;
};

class AnsweringPeer final : public wire::Peer::Server {
 public:
  explicit AnsweringPeer(Answers& answers) : answers_(answers) {}

 protected:
  kj::Promise<void> ping(PingContext context) override {
    const auto in = context.getParams();
    if (in.hasComponents()) name(in.getComponents());
    // A task that does not move stays due at the moment at which it first was.
    const unsigned turn = answers_.asked++;
    if (answers_.sleep != Duration{0}) clockOfTest().suspend(answers_.sleep);
    if (turn >= answers_.silentAfter) return kj::NEVER_DONE;
    if (turn < answers_.overdue.size()) due_ = now() - answers_.overdue[turn];
    auto out = context.getResults();
    out.setSent(toNanoseconds(now()));
    auto tasks = out.initTasks(static_cast<unsigned>(answers_.components.size()));
    for (unsigned i = 0; i < tasks.size(); ++i) {
      toWire({Activity::Asleep, answers_.components[i] == "Arm" ? due_ : now()}, tasks[i]);
    }
    return kj::READY_NOW;
  }

 private:
  void name(capnp::List<capnp::Text>::Reader components) {
    ++answers_.named;
    answers_.components.clear();
    for (const auto one : components) answers_.components.push_back(one);
  }

  Answers& answers_;
  Time due_{};
};

/// Holds one watch, and what it says of its loss.
class Watched {
 public:
  Watched(Heartbeat& heartbeat, std::string component, Heartbeat::Bounds bounds) {
    auto pair = kj::newPromiseAndFulfiller<std::string>();
    lost_ = kj::mv(pair.promise);
    watch_ = heartbeat.watch(std::move(component), bounds,
                             [out = kj::mv(pair.fulfiller)](std::string why) mutable {
                               EXPECT_TRUE(out->isWaiting()) << "it is told twice: " << why;
                               out->fulfill(std::move(why));
                             });
  }

  Heartbeat::Watch* operator->() { return watch_; }
  /// Resolves with the reason. Call it once.
  kj::Promise<std::string> whenLost() { return kj::mv(lost_); }
  void end() { watch_ = nullptr; }

 private:
  kj::Promise<std::string> lost_ = kj::NEVER_DONE;
  kj::Own<Heartbeat::Watch> watch_;
};

class HeartbeatTest : public testing::Test {
 public:
  ~HeartbeatTest() noexcept override {}

 protected:
  /// Returns what comes first: that the component is well, or that it is lost and why.
  std::string firstOf(std::vector<Duration> overdue) {
    answers_.overdue = std::move(overdue);
    auto well = watch_->whenItWorks().then([] { return std::string("well"); });
    return watch_.whenLost().exclusiveJoin(kj::mv(well)).wait(port_.scope());
  }
  /// Returns why the component is lost, or "not lost" after many times what any bound takes.
  std::string whyLost(std::vector<Duration> overdue) {
    answers_.overdue = std::move(overdue);
    auto never =
        port_.getTimer().afterDelay(1 * kj::MINUTES).then([] { return std::string("not lost"); });
    return watch_.whenLost().exclusiveJoin(kj::mv(never)).wait(port_.scope());
  }

  loop::EventPort port_;
  Answers answers_;
  Heartbeat heartbeat_{port_.getTimer(), kj::heap<AnsweringPeer>(answers_)};
  Watched watch_{heartbeat_, "Arm", kBounds};
};

TEST_F(HeartbeatTest, ATaskInTimeIsWell) {
  EXPECT_EQ(firstOf({0ms}), "well");
  EXPECT_EQ(answers_.asked, 1u);
}

TEST_F(HeartbeatTest, ATaskThatDoesNotMoveHangs) {
  EXPECT_TRUE(firstOf({3s}).starts_with("hung: the thread of 'Arm' should have begun a cycle"));
}

TEST_F(HeartbeatTest, ATaskThatStopsMovingLaterHangs) {
  EXPECT_TRUE(whyLost({0ms, 0ms, 0ms, 3s}).starts_with("hung: the thread of 'Arm'"));
}

TEST_F(HeartbeatTest, AMutePeerIsLost) {
  answers_.silentAfter = 0;
  const Time begun = now();
  EXPECT_TRUE(whyLost({}).starts_with("silent: its process has not answered for 5000 ms"));
  EXPECT_EQ(now() - begun, kBounds.silence);
}

// The peer's news of this process is as old as if the peer had been silent. A look was due in
// 10 ms, a tenth of the bound on hanging.
TEST_F(HeartbeatTest, ASleepOfThisProcessIsBlamed) {
  answers_.silentAfter = 0;
  answers_.sleep = kBounds.silence + 3s;
  EXPECT_EQ(whyLost({}), "silent: this process has not run for 8010 ms");
}

TEST_F(HeartbeatTest, APeerThatFallsSilentIsLost) {
  answers_.silentAfter = 3;
  const Time begun = now();
  EXPECT_TRUE(whyLost({0ms, 0ms, 0ms}).starts_with("silent: its process has not answered"));
  EXPECT_EQ(now() - begun, kBounds.silence + 3 * (kBounds.hang / 10));
}

// A connection whose silence suits no round trip is lost again and again.
TEST_F(HeartbeatTest, ALossBlamesATooShortSilence) {
  answers_.silentAfter = 0;
  heartbeat_.noteRoundTrip(2100ms);
  heartbeat_.noteRoundTrip(3s);
  EXPECT_EQ(whyLost({}),
            "silent: its process has not answered for 5000 ms, but answers take "
            "2100 ms: let \"silence\" be at least 5250 ms");
}

TEST_F(HeartbeatTest, ALossBlamesNoFittingSilence) {
  answers_.silentAfter = 0;
  heartbeat_.noteRoundTrip(2s);
  EXPECT_EQ(whyLost({}), "silent: its process has not answered for 5000 ms");
}

TEST_F(HeartbeatTest, AnAnsweringPeerIsNeverLost) {
  const std::size_t asksOfAMinute = 1min / (kBounds.hang / 10);
  EXPECT_EQ(whyLost(std::vector<Duration>(asksOfAMinute + 1, 0ms)), "not lost");
  EXPECT_GE(answers_.asked, asksOfAMinute);
}

// It answers before its tasks have had a turn.
TEST_F(HeartbeatTest, AStoppedProcessIsWellAgain) {
  EXPECT_EQ(firstOf({3s, 0ms}), "well");
  EXPECT_EQ(answers_.asked, 2u);
}

// ---- several watches of one session

TEST_F(HeartbeatTest, EachWatchHasItsOwnSilence) {
  answers_.silentAfter = 1;
  Watched strict(heartbeat_, "Arm", {.silence = 200ms, .hang = 5s});
  const Time begun = now();
  EXPECT_EQ(strict.whenLost().wait(port_.scope()),
            "silent: its process has not answered for 200 ms");
  EXPECT_LT(now() - begun, 300ms);
  EXPECT_FALSE(heartbeat_.silent()) << "another watch bears more";
  EXPECT_TRUE(whyLost({0ms}).starts_with("silent: its process has not answered for 5000 ms"));
  EXPECT_TRUE(heartbeat_.silent());
}

// A connection that is taken down must not delay the loss of the others.
TEST_F(HeartbeatTest, IsSilentOnceNoWatchBearsIt) {
  answers_.silentAfter = 1;
  Watched strict(heartbeat_, "Arm", {.silence = 200ms, .hang = 5s});
  strict.whenLost().wait(port_.scope());
  EXPECT_FALSE(heartbeat_.silent());
  watch_.end();
  EXPECT_TRUE(heartbeat_.silent());
}

TEST_F(HeartbeatTest, EachComponentsTaskIsJudgedAlone) {
  Watched other(heartbeat_, "Camera", kBounds);
  answers_.overdue = {0ms, 0ms, 3s};
  auto otherLost = other.whenLost().eagerlyEvaluate(nullptr);
  EXPECT_TRUE(watch_.whenLost().wait(port_.scope()).starts_with("hung: the thread of 'Arm'"));
  EXPECT_FALSE(otherLost.poll(port_.scope()));
}

// A heartbeat is as long with 256 connections to a component as with one.
TEST_F(HeartbeatTest, ComponentsAreToldWhenTheyChange) {
  std::deque<Watched> more;
  for (int i = 0; i < 256; ++i) more.emplace_back(heartbeat_, "Arm", kBounds);
  port_.getTimer().afterDelay(1 * kj::SECONDS).wait(port_.scope());
  EXPECT_EQ(answers_.named, 1u);
  EXPECT_EQ(answers_.components, std::vector<std::string>{"Arm"});
  EXPECT_LE(answers_.asked, 1s / (kBounds.hang / 10) + 2) << "all watches share the questions";
}

// It begins with a silence that is longer than it bears, and is not lost for that.
TEST_F(HeartbeatTest, ALaterWatchCountsFromThen) {
  answers_.silentAfter = 2;
  port_.getTimer().afterDelay(1 * kj::SECONDS).wait(port_.scope());
  Watched later(heartbeat_, "Arm", {.silence = 500ms, .hang = 5s});
  const Time begun = now();
  EXPECT_TRUE(later.whenLost().wait(port_.scope()).starts_with("silent: "));
  EXPECT_GE(now() - begun, 500ms);
}

// ---- a peer that is gone

TEST_F(HeartbeatTest, AllWatchesHearOfAGonePeer) {
  Watched other(heartbeat_, "Camera", kBounds);
  heartbeat_.end("closed");
  heartbeat_.end("closed again");
  EXPECT_EQ(watch_.whenLost().wait(port_.scope()), "closed");
  EXPECT_EQ(other.whenLost().wait(port_.scope()), "closed");
  EXPECT_EQ(Watched(heartbeat_, "Arm", kBounds).whenLost().wait(port_.scope()), "closed");
}

}  // namespace
}  // namespace suture
