// These tests lose, delay and repeat single messages on each lane, and say what must hold all the
// same.

#include <gtest/gtest.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/observe/merge.h>
#include <suture/observe/observe.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <tuple>

#include "fault/history/history_arm.h"
#include "fault/history/history_caller.h"
#include "fault/history/history_sums.h"
#include "fault/system.h"
#include "support/patience.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

enum class LaneUnderFault { Local, Shm, Frame, Rpc };
constexpr const char* kLanes[] = {"Local", "Shm", "Frame", "Rpc"};
const Lane kAsked[] = {Lane::Auto, Lane::Auto, Lane::Frame, Lane::Rpc};
// The lane of a connection with faults has such a name.
constexpr const char* kLaneNames[] = {"local+fault", "shm+fault", "frame+fault", "rpc+fault"};

struct Fault {
  const char* name;
  FaultPlan plan;
  // The receiver must notice these effects of the fault; no others are checked.
  bool loses = false, duplicates = false, overtakes = false;
  // The fault may not lose even one message.
  bool keeps = false;
};

// A stall is longer than the ttl of a command and the deadline of a call.
const Fault kFaults[] = {
    {.name = "Loss", .plan = {.loss = 0.1}, .loses = true},
    {.name = "BurstLoss", .plan = {.burst = 0.01, .burstLength = 12}, .loses = true},
    {.name = "Duplicate", .plan = {.duplicate = 0.3}, .duplicates = true, .keeps = true},
    {.name = "Reorder", .plan = {.reorder = 0.2, .holdBack = 20ms}, .overtakes = true},
    {.name = "Delay", .plan = {.delay = 0.05, .delayLength = 40ms}, .keeps = true},
    {.name = "Jitter", .plan = {.jitter = 8ms}, .overtakes = true},
    {.name = "Stall", .plan = {.stall = 0.01, .stallLength = 700ms}, .keeps = true},
    {.name = "AllAtOnce",
     .plan = {.loss = 0.05,
              .burst = 0.005,
              .duplicate = 0.1,
              .reorder = 0.1,
              .delay = 0.02,
              .jitter = 3ms,
              .stall = 0.002,
              .stallLength = 300ms},
     .loses = true,
     .duplicates = true,
     .overtakes = true},
};

// So many calls of ask() are enough, since each leaves four entries in a history.
constexpr int kEnoughAsked = 10;

Duration faultTime() {
  const char* asked = std::getenv("SUTURE_FAULT_SECONDS");
  return asked == nullptr ? 400ms : Duration(std::chrono::seconds(std::atoi(asked)));
}

/// Two managers in one process are two processes to each other: nothing is shared but the sockets.
class Messages : public testing::TestWithParam<std::tuple<LaneUnderFault, Fault>> {
 protected:
  Messages() {
    plan_.seed = faultSeed();
    plan_.counts = std::make_shared<FaultCounts>();
    if (lane() != LaneUnderFault::Local) {
      names_ = std::make_unique<Names>("unix:" + directory_.file("m.sock"));
    }
    clients_ = makeManager("client");
    clients_->add("Client", *caller_);
    startProvider();
    clients_->start();
    clients_->connect("Client/Arm", lane() == LaneUnderFault::Local ? "PSM/Arm" : "robot:PSM/Arm",
                      {.lane = kAsked[static_cast<int>(lane())],
                       .patience = kPatience,
                       .delay = {.faults = plan_}});
  }
  ~Messages() override {
    clients_->stop();
    if (providers_ != nullptr) providers_->stop();
  }

  LaneUnderFault lane() const { return std::get<0>(GetParam()); }
  Fault fault() const { return std::get<1>(GetParam()); }
  void startProvider() {
    logs_.push_back(directory_.file("p" + std::to_string(logs_.size())));
    arms_.push_back(std::make_unique<reference::HistoryArm>(
        logs_.back(), static_cast<std::uint32_t>(arms_.size() + 1)));
    if (names_ == nullptr) return clients_->add("PSM", *arms_.back());
    providers_ = makeManager("robot");
    providers_->add("PSM", *arms_.back());
    providers_->start();
  }
  /// The provider says what became of its commands, and ends.
  void endProvider() {
    Manager& manager = lane() == LaneUnderFault::Local ? *clients_ : *providers_;
    arms_.back()->stop();
    const ConnectionReport served = reportOf(manager, ConnectionEnd::Provider);
    arms_.back()->noteLedger(1, sumsOf(served, manager.incarnation()));
    if (providers_ != nullptr) providers_->stop();
  }
  /// The reports of both processes together have a place for each command.
  void expectMergedSums() const {
    const auto merged = mergeConnections({observe(*clients_, now()), observe(*providers_, now())});
    ASSERT_EQ(merged.size(), 1u);
    const ConnectionReport& whole = merged.front();
    EXPECT_EQ(whole.commands() + whole.lost + whole.unknown + whole.underWay, whole.sent);
  }
  void restartProvider() {
    endProvider();
    providers_.reset();
    startProvider();
  }
  void ask() {
    ++asked_;
    caller_->waitForEvents(now() + 2ms);
    caller_->processEvents();
    caller_->ask();
    (void)caller_->arm.hold();
    const auto pose = caller_->arm.measured_cp();
    if (!pose) return;
    EXPECT_GE(pose.stamp(), lastRead_);
    lastRead_ = pose.stamp();
    ++reads_;
  }
  /// Asks for so long, and on until the condition holds: by chance a fault may come late, or hold
  /// up almost everything.
  template <typename Condition>
  bool askFor(Duration time, Condition holds) {
    const Time enough = now() + time, tooLong = enough + 60s;
    while (now() < enough || !holds()) {
      if (now() > tooLong) return false;
      ask();
    }
    return true;
  }
  ConnectionReport report() const { return reportOf(*clients_, ConnectionEnd::Client); }
  /// Tells if the fault has been noticed and rows have come all the same: a stall can hold up every
  /// row for as long as the test asks.
  bool wasUnderFault() const {
    const ConnectionReport seen = report();
    return reads_ > 0 && plan_.counts->total() > 0 && (!fault().loses || seen.messagesLost > 0) &&
           (!fault().duplicates || seen.messagesDuplicated > 0) &&
           (!fault().overtakes || seen.messagesOvertaken > 0);
  }
  // Tells if each credit is back, since no command may keep its place at the provider for ever.
  bool creditsAreBack() const {
    const auto& channel = caller_->arm.channel();
    for (std::uint16_t i = 0; i < channel->info.commands.size(); ++i) {
      if (channel->commands.waiting(i) != 0) return false;
    }
    return true;
  }
  bool callIsAnswered() {
    return eventually([this] {
      return caller_->arm.distance.start(reference::PoseStamped{}).within(200ms).has_value();
    });
  }
  void expectSound() {
    EXPECT_TRUE(callIsAnswered());
    EXPECT_TRUE(eventually([this] { return creditsAreBack(); }));
    EXPECT_GT(reads_, 0);
    EXPECT_GT(plan_.counts->total(), 0u);
    EXPECT_TRUE(eventually([this] { return report().underWay == 0; }));
    if (providers_ != nullptr && arms_.size() == 1) expectMergedSums();
    std::uint64_t others = 0;
    for (const auto& arm : arms_) others += arm->others();
    caller_->noteLedger(sumsOf(report(), clients_->incarnation()), others);
    endProvider();
    std::printf("seed %u: %d faults\n", faultSeed(), static_cast<int>(plan_.counts->total()));
    std::vector<std::string> logs = logs_;
    logs.push_back(directory_.file("c"));
    const auto history = readHistory(logs);
    EXPECT_GT(history.size(), 20u);
    expectSoundHistory(history, {});  // nothing is late on a stepped clock
  }

  struct Names {
    explicit Names(const std::string& address) : global(control, address) {}
    loop::ControlThread control;
    GlobalManager global;
  };
  std::unique_ptr<Manager> makeManager(const std::string& name) {
    return names_ == nullptr ? std::make_unique<Manager>(name)
                             : std::make_unique<Manager>(name, names_->global.address());
  }

  const TemporaryDirectory directory_;
  FaultPlan plan_ = fault().plan;
  std::vector<std::string> logs_;
  std::unique_ptr<Names> names_;
  std::vector<std::unique_ptr<reference::HistoryArm>> arms_;
  std::unique_ptr<HistoryCaller> caller_ = std::make_unique<HistoryCaller>(directory_.file("c"), 1);
  std::unique_ptr<Manager> clients_, providers_;
  Time lastRead_{};
  int asked_ = 0, reads_ = 0;
};

std::string nameOfFaultOnLane(
    const testing::TestParamInfo<std::tuple<LaneUnderFault, Fault>>& info) {
  return std::string(std::get<1>(info.param).name) + "On" +
         kLanes[static_cast<int>(std::get<0>(info.param))];
}

INSTANTIATE_TEST_SUITE_P(
    Faults, Messages,
    testing::Combine(testing::Values(LaneUnderFault::Local, LaneUnderFault::Shm,
                                     LaneUnderFault::Frame, LaneUnderFault::Rpc),
                     testing::ValuesIn(kFaults)),
    nameOfFaultOnLane);

TEST_P(Messages, LeaveASoundHistory) {
  EXPECT_TRUE(askFor(faultTime(), [this] { return wasUnderFault() && asked_ > kEnoughAsked; }));
  const ConnectionReport seen = report();
  EXPECT_EQ(seen.lane, kLaneNames[static_cast<int>(lane())]);
  EXPECT_EQ(seen.status, ChannelStatus::Connected);
  if (fault().keeps) {
    EXPECT_EQ(seen.messagesLost, 0u);
    EXPECT_EQ(seen.messagesOvertaken, 0u);
  }
  expectSound();
}

class MessagesAndLosses : public Messages {};

INSTANTIATE_TEST_SUITE_P(Faults, MessagesAndLosses,
                         testing::Combine(testing::Values(LaneUnderFault::Shm,
                                                          LaneUnderFault::Frame,
                                                          LaneUnderFault::Rpc),
                                          testing::Values(kFaults[7])),
                         nameOfFaultOnLane);

// Messages that are held up on a connection that was lost do not arrive on the next.
TEST_P(MessagesAndLosses, LeaveASoundHistory) {
  for (int restart = 0; restart < 3; ++restart) {
    const int before = asked_;
    EXPECT_TRUE(askFor(faultTime() / 4, [&] { return asked_ > before + 3; }));
    restartProvider();
    lastRead_ = {};
    ASSERT_TRUE(eventually([this] {
      ask();
      return caller_->arm.connected();
    }));
  }
  EXPECT_TRUE(askFor(faultTime() / 4, [this] { return reads_ > 0 && asked_ > kEnoughAsked; }));
  expectSound();
}

}  // namespace
}  // namespace suture
