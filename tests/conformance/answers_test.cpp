// These commands have several arguments, or return a value.
#include <suture/component/channel/channel.h>

#include <limits>

#include "conformance/setup.h"
#include "support/patience.h"

namespace conformance {
namespace {

using namespace std::chrono_literals;
using suture::Errc;
using suture::kPatience;

class Answers : public Conformance {};
class WireAnswers : public Conformance {};
/// The provider does not execute them before start() returns.
class QueuedAnswers : public Conformance {};
/// A process judges what another one sends, not what it sends itself.
class JudgedArguments : public Conformance {};

TEST_P(Answers, SeveralArgumentsArriveInTheirPlaces) {
  client->with([](Arm& remote) {
    EXPECT_TRUE(remote.limit(12, Mode::Enabled));
    EXPECT_TRUE(remote.limit.start(7, Mode::Disabled).within(kPatience));
  });
  EXPECT_TRUE(eventuallyTaken({"limit 12 enabled", "limit 7 disabled"}));
}

TEST_P(WireAnswers, AWriteWithReturnRunsAndAnswers) {
  client->with([&](Arm& remote) {
    const auto fast = remote.move.start(poseAt(3), 0.75, "a hurry").within(kPatience);
    ASSERT_TRUE(fast) << suture::toString(fast.error());
    EXPECT_TRUE(*fast);
    EXPECT_EQ(arm->taken(), (std::vector<std::string>{"servo_cp 3", "move 75% a hurry"}));
    const auto slow = remote.move.start(poseAt(4), 0.25, "").within(kPatience);
    ASSERT_TRUE(slow);
    EXPECT_FALSE(*slow);
  });
  EXPECT_EQ(arm->at([](ArmComponent& one) { return one.measured_cp().pose.translation().x(); }), 4);
}

TEST_P(Answers, AVoidWithReturnAnswers) {
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.hold.start().within(kPatience));
    EXPECT_TRUE(remote.hold.start().within(kPatience));
    const auto forgotten = remote.reset.start().within(kPatience);
    ASSERT_TRUE(forgotten);
    EXPECT_EQ(*forgotten, 2u);
    EXPECT_EQ(*remote.reset.start().within(kPatience), 0u);
  });
}

TEST_P(Answers, TheyKeepTheOrderOfOtherCommands) {
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.hold());
    EXPECT_TRUE(remote.servo_cp(poseAt(1)));
    auto moved = remote.move.start(poseAt(2), 1, "now");
    EXPECT_TRUE(remote.limit(3, Mode::Enabled));
    EXPECT_TRUE(moved.within(kPatience));
  });
  EXPECT_TRUE(
      eventuallyTaken({"hold", "servo_cp 1", "servo_cp 2", "move 100% now", "limit 3 enabled"}));
}

TEST_P(Answers, ItCanBePolled) {
  client->with([](Arm& remote) {
    auto call = remote.reset.start();
    ASSERT_TRUE(awaitInPlace(remote, [&] { return call.poll() != nullptr; }));
    EXPECT_TRUE(call.poll()->has_value());
  });
}

TEST_P(QueuedAnswers, TheContractsDeadlineHoldsByDefault) {
  arm->gate().close();
  client->with([](Arm& remote) {
    const auto begin = suture::now();
    const auto late = remote.move.start(poseAt(1), 1, "wait").within();
    ASSERT_FALSE(late);
    EXPECT_EQ(late.error(), Errc::Timeout);
    EXPECT_GE(suture::now() - begin, 200ms);
  });
  arm->gate().open();
}

TEST_P(QueuedAnswers, ATooLargeArgumentIsRefused) {
  client->with([](Arm& remote) {
    const auto text = remote.move.start(poseAt(1), 1, "a reason of 16 c").within(kPatience);
    ASSERT_FALSE(text);
    EXPECT_EQ(text.error(), Errc::TooLarge);
  });
  EXPECT_TRUE(arm->taken().empty());
}

// The sender is told at once, also by a command that awaits no answer, and hears what was wrong.
TEST_P(JudgedArguments, InvalidArgumentsAreRefusedAtTheSender) {
  client->with([](Arm& remote) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const auto unknown = static_cast<Mode>(77);
    const auto refused = [&remote](const auto& answer) {
      EXPECT_EQ(answer ? Errc{} : answer.error(), Errc::Invalid);
      return std::string(remote.lastInvalid().text());
    };
    EXPECT_EQ(remote.lastInvalid().text(), "");
    EXPECT_EQ(refused(remote.move.start(poseAt(1), 1.5, "").within(0s)), "move.speed");
    EXPECT_EQ(refused(remote.servo_cp(poseAt(kNone))), "servo_cp.goal.pose");
    EXPECT_EQ(refused(remote.limit(kNone, Mode::Enabled)), "limit.speed");
    EXPECT_EQ(refused(remote.limit(1, unknown)), "limit.mode");
    EXPECT_EQ(refused(remote.servo_jp({{}, {0, 1, kNone}})), "servo_jp.goal.position[2]");
    EXPECT_TRUE(remote.limit(1, Mode::Enabled));
    EXPECT_EQ(refused(remote.set_mode(unknown)), "set_mode.mode");
  });
  EXPECT_TRUE(eventuallyTaken({"limit 1 enabled"}));
  EXPECT_EQ(channel()->commands.counters.invalid, 6u);
}

TEST_P(Answers, AThrowIsAnAnswerToo) {
  client->with([](Arm& remote) {
    const auto thrown = remote.move.start(poseAt(1), 1, "throw").within(kPatience);
    ASSERT_FALSE(thrown);
    EXPECT_EQ(thrown.error(), Errc::Faulted);
  });
}

TEST_P(Answers, AnOptionalCommandThatIsThereWorks) {
  client->with([](Arm& remote) { EXPECT_TRUE(remote.park.start().within(kPatience)); });
}

INSTANTIATE_TEST_SUITE_P(Lanes, Answers, testing::ValuesIn(laneRows()), nameOf);
INSTANTIATE_TEST_SUITE_P(Lanes, WireAnswers, testing::ValuesIn(wireRows()), nameOf);
INSTANTIATE_TEST_SUITE_P(Lanes, QueuedAnswers, testing::ValuesIn(laneRows(isQueued)), nameOf);
INSTANTIATE_TEST_SUITE_P(Lanes, JudgedArguments, testing::ValuesIn(wireRows()), nameOf);

}  // namespace
}  // namespace conformance
