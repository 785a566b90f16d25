// Some lanes lose, repeat and reorder messages. What the client sent and the provider executed must
// keep the rules of a history all the same (fault/history/history.h).
#include <suture/component/channel/channel.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "conformance/setup.h"
#include "fault/history/history.h"

namespace conformance {
namespace {

using namespace std::chrono_literals;
using suture::Errc;
using suture::HistoryEntry;

/// Returns the seed of all faults; SUTURE_FAULT_SEED chooses another one, to replay a failure.
std::uint64_t seed() {
  const char* const asked = std::getenv("SUTURE_FAULT_SEED");
  return asked == nullptr ? 1 : std::strtoull(asked, nullptr, 10);
}

class Losses : public Conformance {
 protected:
  static constexpr suture::Duration kDeadline = 20ms;

  void SetUp() override {
    Conformance::SetUp();
    arm->at([log = Text(file("provider"))](ArmComponent& one) { one.keepHistory(log.text); });
    log_.emplace(file("client"));
    client->with([this](Arm& remote) {
      EXPECT_TRUE(remote.on().arrived([this](const PoseStamped& tag) {
        note({.kind = HistoryEntry::Kind::Heard,
              .id = static_cast<std::uint64_t>(tag.pose.translation().y()),
              .epoch = 1});
      }));
    });
  }

  suture::FaultPlan faults() const override {
    switch (GetParam().filter) {
      case Filter::Loss: return {.seed = seed(), .loss = 0.1, .counts = counts_};
      case Filter::BurstLoss:
        return {.seed = seed(), .burst = 0.02, .burstLength = 12, .counts = counts_};
      case Filter::Duplicates: return {.seed = seed(), .duplicate = 0.3, .counts = counts_};
      default: return {.seed = seed(), .reorder = 0.2, .counts = counts_};
    }
  }
  /// Tells if the receivers have noticed what the lane does to messages.
  bool isNoticed() const {
    const suture::DeliveryCounters& seen = channel()->client.delivery;
    switch (GetParam().filter) {
      case Filter::Duplicates: return seen.duplicated > 0;
      case Filter::Reordering: return seen.overtaken > 0;
      default: return seen.lost > 0;
    }
  }

  /// Sends a command, a call and an event, and takes what has arrived until then.
  void exchange() {
    client->with([this](Arm& remote) {
      const PoseStamped goal = sent({});
      const auto posted = remote.servo_cp(goal);
      ended(posted ? Errc{} : posted.error());
      const PoseStamped target = sent(kDeadline);
      const auto moved = remote.move.start(target, 1, "").within(kDeadline);
      ended(moved ? Errc{} : moved.error());
    });
    arm->emitSoon([number = ++events_](Ports ports) {
      PoseStamped tag = poseAt(1);
      tag.pose.translation().y() = number;
      ports.arm.emit().arrived(tag);  // if the queue is full, the loss is counted
    });
    client->await([](const Received&) { return true; });
  }
  bool isAnswered() {
    bool answered = false;
    client->with(
        [&](Arm& remote) { answered = remote.distance.start({}).within(50ms).has_value(); });
    return answered;
  }
  /// Tells if each credit is back, since no command may keep its place at the provider for ever.
  bool creditsAreBack() const {
    const auto connection = channel();
    for (std::uint16_t i = 0; i < connection->info.commands.size(); ++i) {
      if (connection->commands.waiting(i) != 0) return false;
    }
    return true;
  }
  /// Both ends say what became of the commands, none of which is under way any more.
  void noteLedgers() {
    const std::uint64_t others = arm->at([](ArmComponent& one) { return one.others(); });
    note({.kind = HistoryEntry::Kind::Counted, .id = others, .sums = clientsSums()});
    arm->noteLedger();
  }

  const std::shared_ptr<suture::FaultCounts> counts_ = std::make_shared<suture::FaultCounts>();

 private:
  void note(HistoryEntry entry) {
    entry.at = suture::now();
    entry.client = 1;
    log_->write(entry);
  }
  PoseStamped sent(suture::Duration limit) {
    note({.kind = HistoryEntry::Kind::Sent, .id = ++commands_, .epoch = 1, .limit = limit});
    PoseStamped tag = poseAt(1);
    tag.pose.translation().tail<2>() << static_cast<double>(commands_), 1;
    return tag;
  }
  void ended(Errc error) {
    note({.kind = HistoryEntry::Kind::Ended, .id = commands_, .epoch = 1, .error = error});
  }

  std::optional<suture::HistoryLog> log_;
  std::uint64_t commands_ = 0;
  int events_ = 0;
};

TEST_P(Losses, LeaveASoundHistory) {
  constexpr int kEnough = 40, kTooMany = 2000;
  int exchanges = 0;
  while (exchanges < kEnough || (!isNoticed() && exchanges < kTooMany)) {
    exchange();
    ++exchanges;
  }
  EXPECT_TRUE(isNoticed()) << "seed " << seed();
  EXPECT_GT(counts_->total(), 0u);
  EXPECT_TRUE(suture::eventually([&] { return isAnswered(); }));
  EXPECT_TRUE(suture::eventually([&] { return creditsAreBack(); }));
  EXPECT_TRUE(suture::eventually([&] { return clientsSums().underWay == 0; }));
  noteLedgers();

  const auto history = suture::readHistory({file("client"), file("provider")});
  const auto entries = [&history](HistoryEntry::Kind kind) {
    return std::count_if(history.begin(), history.end(),
                         [kind](const HistoryEntry& entry) { return entry.kind == kind; });
  };
  EXPECT_EQ(entries(HistoryEntry::Kind::Ended), 2 * exchanges);
  EXPECT_GT(entries(HistoryEntry::Kind::Executed), exchanges / 2);
  EXPECT_GT(entries(HistoryEntry::Kind::Heard), exchanges / 4);
  EXPECT_EQ(entries(HistoryEntry::Kind::Counted), 1);
  EXPECT_EQ(entries(HistoryEntry::Kind::Served), 1);
  // A busy machine may hold a thread up between its deadline and its look at the clock, but nothing
  // is late on a stepped clock.
  const suture::Duration lateness = clock ? 0s : 2s;
  for (const std::string& violation : violations(history, {.lateness = lateness})) {
    ADD_FAILURE() << violation << ", seed " << seed();
  }
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Losses);  // over a lane that was added
INSTANTIATE_TEST_SUITE_P(Lanes, Losses, testing::ValuesIn(lossyRows()), nameOf);

}  // namespace
}  // namespace conformance
