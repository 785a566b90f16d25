// A heartbeat tells a silent peer and a task that hangs by what the process answers.

#include <gtest/gtest.h>
#include <suture/loop/event_port.h>
#include <suture/session/heartbeat.h>

#include <limits>
#include <vector>

namespace suture {
namespace {

using namespace std::chrono_literals;

constexpr Heartbeat::Bounds kBounds{.silence = 5s, .hang = 100ms};

/// What a process tells of its task "Arm": one answer after the other, the last again and again.
struct Answers {
  std::vector<Duration> overdue;
  unsigned silentAfter = std::numeric_limits<unsigned>::max();
  unsigned asked = 0;
};

class AnsweringPeer final : public wire::Peer::Server {
 public:
  explicit AnsweringPeer(Answers& answers) : answers_(answers) {}

 protected:
  kj::Promise<void> ping(PingContext context) override {
    // One that does not move stays due at the moment at which it first was.
    const unsigned turn = answers_.asked++;
    if (turn >= answers_.silentAfter) return kj::NEVER_DONE;
    if (turn < answers_.overdue.size()) due_ = now() - answers_.overdue[turn];
    auto out = context.getResults();
    out.setSent(toNanoseconds(now()));
    auto task = out.initTasks(1)[0];
    task.setComponent("Arm");
    toWire({Activity::Asleep, due_}, task);
    return kj::READY_NOW;
  }

 private:
  Answers& answers_;
  Time due_{};
};

class HeartbeatTest : public testing::Test {
 public:
  ~HeartbeatTest() noexcept override {}

 protected:
  /// Which comes first: the component is well, or lost and why.
  std::string firstOf(std::vector<Duration> overdue) {
    answers_.overdue = std::move(overdue);
    auto well = heartbeat_.whenWell().then([] { return std::string("well"); });
    return heartbeat_.whenLost().exclusiveJoin(kj::mv(well)).wait(port_.scope());
  }
  /// Why the component is lost, or "not lost" after many times what any bound takes.
  std::string whyLost(std::vector<Duration> overdue) {
    answers_.overdue = std::move(overdue);
    auto never =
        port_.getTimer().afterDelay(1 * kj::MINUTES).then([] { return std::string("not lost"); });
    return heartbeat_.whenLost().exclusiveJoin(kj::mv(never)).wait(port_.scope());
  }

  rpc::EventPort port_;
  Answers answers_;
  Heartbeat heartbeat_{port_.getTimer(), kj::heap<AnsweringPeer>(answers_), "Arm", kBounds};
};

TEST_F(HeartbeatTest, ATaskThatIsInTimeIsWell) {
  EXPECT_EQ(firstOf({0ms}), "well");
  EXPECT_EQ(answers_.asked, 1u);
}

TEST_F(HeartbeatTest, ATaskThatDoesNotMoveHangs) {
  EXPECT_TRUE(firstOf({3s}).starts_with("hung: the thread of 'Arm' should have begun a cycle"));
}

TEST_F(HeartbeatTest, ATaskThatStopsMovingLaterHangs) {
  EXPECT_TRUE(whyLost({0ms, 0ms, 0ms, 3s}).starts_with("hung: the thread of 'Arm'"));
}

TEST_F(HeartbeatTest, APeerThatNeverAnswersIsLostWhenTheBoundHasPassed) {
  answers_.silentAfter = 0;
  const Time begun = now();
  EXPECT_TRUE(whyLost({}).starts_with("silent: its process has not answered for 5000 ms"));
  EXPECT_EQ(now() - begun, kBounds.silence);
}

TEST_F(HeartbeatTest, APeerThatFallsSilentAfterSomeAnswersIsLost) {
  answers_.silentAfter = 3;
  const Time begun = now();
  EXPECT_TRUE(whyLost({0ms, 0ms, 0ms}).starts_with("silent: its process has not answered"));
  EXPECT_EQ(now() - begun, kBounds.silence + 3 * (kBounds.hang / 10));
}

TEST_F(HeartbeatTest, APeerThatGoesOnAnsweringIsNeverLost) {
  const std::size_t asksOfAMinute = 1min / (kBounds.hang / 10);
  EXPECT_EQ(whyLost(std::vector<Duration>(asksOfAMinute + 1, 0ms)), "not lost");
  EXPECT_GE(answers_.asked, asksOfAMinute);
}

// It answers before its tasks have had a turn.
TEST_F(HeartbeatTest, AProcessThatWasStoppedAsAWholeIsWellAgain) {
  EXPECT_EQ(firstOf({3s, 0ms}), "well");
  EXPECT_EQ(answers_.asked, 2u);
}

}  // namespace
}  // namespace suture
