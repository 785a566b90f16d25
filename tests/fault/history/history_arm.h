#pragma once
// This is an arm that writes down what it executes.

#include <suture/component/task/periodic_task.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "fault/history/history.h"
#include "fault/tag.h"
#include "reference/still_arm.h"
#include "support/pass.h"

namespace reference {

/// A move with this reason tells the test that it runs.
inline constexpr const char* kTellsThatItRuns = "tell";

/// Emits events in each cycle: the arm's number and the event's.
class HistoryArm final : public suture::PeriodicTask, public suture::StillArm {
 public:
  HistoryArm(const std::string& log, std::uint32_t number, int eventsPerCycle = 1)
      : PeriodicTask({.period = std::chrono::milliseconds(2)}),
        log_(log),
        number_(number),
        eventsPerCycle_(eventsPerCycle) {}

  /// A move with the reason kTellsThatItRuns calls this.
  std::function<void()> whenItRuns = [] {};

  double distance(const PoseStamped& goal) const override {
    ++executions_;
    ++distances_;
    return StillArm::distance(goal);
  }

  /// Notes, once it has been stopped, what the report of its process says of the commands of client
  /// number `client`, who alone may have sent others().
  void noteLedger(std::uint32_t client, const suture::HistorySums& sums) {
    log_.write({.kind = suture::HistoryEntry::Kind::Served,
                .at = suture::now(),
                .client = client,
                .id = executedOf_[client] + others(),
                .sums = sums});
  }

  /// Any thread: its next cycle takes so long.
  void hang(suture::Duration length) { hangs_ = length.count(); }

  /// Any thread: returns how many commands it has executed so far.
  std::uint64_t executions() const { return executions_; }
  /// Any thread: returns how many of its commands are in no history, since they carry no tag.
  std::uint64_t others() const { return static_cast<unsigned>(holds) + distances_; }
  /// Any thread: returns how many events it has emitted so far.
  std::uint64_t emitted() const { return events_; }

  void servo_cp(const PoseStamped& goal) override {
    executed(goal, std::chrono::milliseconds(500));
  }
  bool move(const PoseStamped& goal, double speed, const std::string& reason) override {
    executed(goal, suture::Duration{0});
    if (reason == kTellsThatItRuns) whenItRuns();
    suture::pass(
        std::chrono::duration_cast<suture::Duration>(std::chrono::duration<double>(speed)));
    return true;
  }

 private:
  void executed(const PoseStamped& goal, suture::Duration ttl) {
    ++executions_;
    const Tag tag = tagIn(goal);
    ++executedOf_[tag.who];
    log_.write({.kind = suture::HistoryEntry::Kind::Executed,
                .at = suture::now(),
                .client = tag.who,
                .id = tag.number,
                .epoch = tag.epoch,
                .limit = ttl,
                .age = arm_.commandAge()});
  }
  void run() override {
    if (hangs_ != 0) suture::pass(suture::Duration{hangs_.exchange(0)});
    for (int i = 0; i < eventsPerCycle_; ++i) {
      arm_.emit().arrived(poseOf({number_, ++events_}));
    }
  }

  suture::HistoryLog log_;
  const std::uint32_t number_;
  const int eventsPerCycle_;
  mutable std::atomic<std::uint64_t> executions_{0};
  mutable std::atomic<std::uint64_t> distances_{0};
  std::atomic<std::uint64_t> events_{0};
  std::atomic<suture::Duration::rep> hangs_{0};
  std::map<std::uint32_t, std::uint64_t> executedOf_;  // commands, by client
  suture::Provided<reference::ArmLike> arm_{*this, "Arm", *this};
};

}  // namespace reference
