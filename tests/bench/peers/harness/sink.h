#pragma once
// A server hands in here what came one way.

#include "harness/clock.h"
#include "harness/control_block.h"
#include "harness/pose.h"

namespace peers {

class Sink {
 public:
  Sink(ControlBlock& control, int server) : control_(&control), server_(server) {}

  ControlBlock& control() const { return *control_; }

  /// One thread calls it for each pose, as soon as it is a pose again.
  void operator()(const Pose& pose) const {
    const std::int64_t time = now();
    if (control_->stamped.load(std::memory_order_relaxed)) keepLatency(pose, time);
    Received& received = control_->received[server_];
    if (pose.timestamp <= received.lastTimestamp.load(std::memory_order_relaxed)) {
      ++received.disorder;
    }
    received.last.store(time, std::memory_order_relaxed);
    const std::uint64_t count = received.count.load(std::memory_order_relaxed);
    received.count.store(count + 1, std::memory_order_release);
    received.lastTimestamp.store(pose.timestamp, std::memory_order_release);
  }

 private:
  void keepLatency(const Pose& pose, std::int64_t time) const {
    const auto number = static_cast<std::int64_t>(pose.position[0]);
    if (number < 0 || number >= kMostPublished) return;
    control_->latency[server_][number] = time - static_cast<std::int64_t>(pose.timestamp);
  }

  ControlBlock* control_;
  int server_;
};

}  // namespace peers
