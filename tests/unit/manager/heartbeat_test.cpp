// Whether a task hangs, by what its process answers.

#include <gtest/gtest.h>
#include <suture/manager/heartbeat.h>
#include <suture/transport/rpc/event_port.h>

#include <vector>

namespace suture {
namespace {

using namespace std::chrono_literals;

constexpr Heartbeat::Bounds kBounds{.silence = 5s, .hang = 100ms};

/// What a process tells of its task "Arm": one answer after the other, the last again and again.
struct Answers {
  std::vector<Duration> overdue;
  unsigned asked = 0;
};

class AnsweringPeer final : public wire::Peer::Server {
 public:
  explicit AnsweringPeer(Answers& answers) : answers_(answers) {}

 protected:
  kj::Promise<void> ping(PingContext context) override {
    // One that does not move stays due at the moment at which it first was.
    const unsigned turn = answers_.asked++;
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
    Heartbeat heartbeat(port_.getTimer(), kj::heap<AnsweringPeer>(answers_), "Arm", kBounds);
    auto well = heartbeat.whenWell().then([] { return std::string("well"); });
    return heartbeat.whenLost().exclusiveJoin(kj::mv(well)).wait(port_.scope());
  }

  rpc::EventPort port_;
  Answers answers_;
};

TEST_F(HeartbeatTest, ATaskThatIsInTimeIsWell) {
  EXPECT_EQ(firstOf({0ms}), "well");
  EXPECT_EQ(answers_.asked, 1u);
}

TEST_F(HeartbeatTest, ATaskThatDoesNotMoveHangs) {
  EXPECT_TRUE(firstOf({3s}).starts_with("hung: the thread of 'Arm' should have begun a cycle"));
}

// It answers before its tasks have had a turn.
TEST_F(HeartbeatTest, AProcessThatWasStoppedAsAWholeIsWellAgain) {
  EXPECT_EQ(firstOf({3s, 0ms}), "well");
  EXPECT_EQ(answers_.asked, 2u);
}

}  // namespace
}  // namespace suture
