#pragma once
// This is a client that writes down what it sends, how that ends, what it hears, and what it is
// told of its connection.

#include <suture/component/channel/channel.h>
#include <suture/component/device.h>
#include <suture/component/required.h>
#include <suture/manager/manager.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "fault/history/history.h"
#include "fault/history/history_arm.h"
#include "fault/tag.h"
#include "reference/arm_like.suture.h"

namespace suture {

/// Shows its connection.
struct HistoryPort final : Required<reference::ArmLike> {
  using Required::channel;
  using Required::Required;
};

/// Its connections count from 1, which are their epochs.
class HistoryCaller final : public Device {
 public:
  HistoryCaller(const std::string& log, std::uint32_t number) : log_(log), number_(number) {
    arm.on().arrived([this](const reference::PoseStamped& pose) {
      const reference::Tag tag = reference::tagIn(pose);
      note({.kind = HistoryEntry::Kind::Heard, .id = tag.number, .epoch = tag.who});
    });
  }

  /// Notes what has become of the connection.
  void look() {
    const Errc error = arm.unusable();
    follow();
    if (error == Errc::Lost) noteLoss();
  }

  /// Reads where the arm is.
  void read() {
    look();
    if (arm.measured_cp().error() == Errc::Stale) noteAwaiting();
  }

  /// Does as its operator does who lets its commands through again, if they await that and its
  /// provider is there. It is connected as `name`.
  void resume(Manager& manager, const char* name) {
    look();
    try {
      manager.resumeConnection(name);
    } catch (const SetupError&) {
      return;
    }
    awaits_ = false;
    note({.kind = HistoryEntry::Kind::Resumed, .epoch = epoch_});
  }

  /// Sends a command and waits for a call, one after the other.
  void ask() {
    look();
    post();
    Command move = command(kDeadline);
    auto moving = arm.move.start(move.goal, kMoveTakes, "");
    move.epoch = follow();
    const auto moved = moving.within(kDeadline);
    noteEnd(move, moved ? Errc{} : moved.error());
    look();
  }

  /// Says how many commands a burst has. The second of them tells the test that it runs.
  static constexpr std::uint64_t kBurst = 6;
  /// Sends them all, then waits for them. The first one keeps the provider busy until the others
  /// have come, so that these wait for one drain.
  void burst() {
    look();
    std::vector<Command> moves;
    std::vector<decltype(arm.move.start(reference::PoseStamped{}, 0, ""))> moving;
    for (const auto& [takes, reason] : kMoves) {
      moves.push_back(command(kBurstDeadline));
      moving.push_back(arm.move.start(moves.back().goal, takes, reason));
      moves.back().epoch = follow();
    }
    post();
    for (std::size_t i = 0; i < moves.size(); ++i) {
      const Time due = moves[i].goal.stamp + kBurstDeadline;
      const auto moved = moving[i].within(std::max(due - now(), Duration{0}));
      noteEnd(moves[i], moved ? Errc{} : moved.error());
    }
    look();
  }

  /// Notes what the report of its process says of its commands, of which `others` were executed
  /// that it did not write down. Nothing is sent any more.
  void noteLedger(const HistorySums& sums, std::uint64_t others = 0) {
    look();
    note({.kind = HistoryEntry::Kind::Counted, .id = others, .sums = sums});
  }

  HistoryPort arm{*this, "Arm"};

 private:
  struct Command {
    std::uint64_t id, epoch;
    Duration deadline;
    reference::PoseStamped goal;
  };
  struct Move {
    double takes;  // s
    const char* reason;
  };

  static constexpr Duration kDeadline = std::chrono::milliseconds(200);
  static constexpr Duration kBurstDeadline = std::chrono::seconds(1);
  static constexpr double kMoveTakes = 0.01;  // s
  static constexpr std::array kMoves{Move{0.02, ""}, Move{0.15, reference::kTellsThatItRuns},
                                     Move{0.002, ""}, Move{0.002, ""}, Move{0.002, ""}};
  static_assert(kBurst == kMoves.size() + 1);

  void note(HistoryEntry entry) {
    entry.at = now();
    entry.client = number_;
    log_.write(entry);
  }
  /// Notes that it is about to be sent.
  Command command(Duration deadline) {
    ++id_;
    note({.kind = HistoryEntry::Kind::Sent, .id = id_, .epoch = epoch_, .limit = deadline});
    Command made{id_, epoch_, deadline, reference::poseOf({number_, id_, epoch_})};
    made.goal.stamp = now();
    return made;
  }
  void post() {
    Command servo = command(Duration{0});
    const auto posted = arm.servo_cp(servo.goal);
    servo.epoch = follow();
    noteEnd(servo, posted ? Errc{} : posted.error());
  }
  void noteEnd(const Command& command, Errc error) {
    note({.kind = HistoryEntry::Kind::Ended,
          .id = command.id,
          .epoch = command.epoch,
          .limit = command.deadline,
          .error = error});
  }
  /// Answers the connection that took what has just been sent.
  std::uint64_t follow() {
    if (arm.channel() == known_) return epoch_;
    if (known_ != nullptr) noteLoss();
    known_ = arm.channel();
    ++epoch_;
    if (known_ != nullptr) {
      note({.kind = HistoryEntry::Kind::Connected, .epoch = epoch_, .lane = known_->lane});
    }
    return epoch_;
  }
  void noteLoss() {
    if (std::exchange(lost_, epoch_) == epoch_) return;
    note({.kind = HistoryEntry::Kind::Told, .epoch = epoch_, .error = Errc::Lost});
    noteAwaiting();
  }
  void noteAwaiting() {
    const ConnectionWatch* const watch = known_->terms.watch.get();  // none without a contract
    const bool hasOperator = watch != nullptr && watch->contract.resume == Resume::Operator;
    if (!hasOperator || awaits_) return;
    awaits_ = true;
    note({.kind = HistoryEntry::Kind::Awaits, .epoch = epoch_});
  }

  HistoryLog log_;
  const std::uint32_t number_;
  std::uint64_t id_ = 0, epoch_ = 0;
  std::uint64_t lost_ = 0;  // it has been told of so many on this connection
  bool awaits_ = false;     // the connection waits for its operator
  std::shared_ptr<Channel> known_;
};

}  // namespace suture
