#pragma once
// A client that writes down what it sends, how that ends, and what it hears.

#include <suture/component/channel.h>
#include <suture/component/device.h>
#include <suture/component/required.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "fault/history.h"
#include "reference/arm_like.suture.h"

namespace suture {

/// Shows its connection.
struct HistoryPort final : Required<reference::ArmLike> {
  using Required::channel;
  using Required::Required;
};

/// Sends a command and waits for a call in each ask(), one after the other.
class HistoryCaller final : public Device {
 public:
  HistoryCaller(const std::string& log, std::uint32_t number) : log_(log), number_(number) {
    arm.on().arrived([this](const reference::PoseStamped& tag) {
      note({.kind = HistoryEntry::Kind::Heard,
            .id = static_cast<std::uint64_t>(tag.pose.translation().y()),
            .epoch = static_cast<std::uint64_t>(tag.pose.translation().x())});
    });
  }

  void ask() {
    (void)arm.connected();
    if (arm.channel() != known_) {
      known_ = arm.channel();
      ++epoch_;
    }
    const reference::PoseStamped goal = sent(Duration{0});
    const auto posted = arm.servo_cp(goal);
    noteEnd(posted ? Errc{} : posted.error());
    const reference::PoseStamped target = sent(kDeadline);
    const auto moved = arm.move.start(target, kMoveTakes, "").within(kDeadline);
    noteEnd(moved ? Errc{} : moved.error());
  }

  HistoryPort arm{*this, "Arm"};

 private:
  static constexpr Duration kDeadline = std::chrono::milliseconds(200);
  static constexpr double kMoveTakes = 0.01;  // s

  void note(HistoryEntry entry) {
    entry.at = now();
    entry.client = number_;
    log_.write(entry);
  }
  reference::PoseStamped sent(Duration deadline) {
    ++id_;
    note({.kind = HistoryEntry::Kind::Sent, .id = id_, .epoch = epoch_, .limit = deadline});
    reference::PoseStamped tag;
    tag.pose.translation() << number_, static_cast<double>(id_), static_cast<double>(epoch_);
    tag.stamp = now();
    tag.valid = true;
    return tag;
  }
  void noteEnd(Errc error) {
    note({.kind = HistoryEntry::Kind::Ended, .id = id_, .epoch = epoch_, .error = error});
  }

  HistoryLog log_;
  const std::uint32_t number_;
  std::uint64_t id_ = 0, epoch_ = 0;
  std::shared_ptr<Channel> known_;
};

}  // namespace suture
