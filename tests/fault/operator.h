#pragma once
// This is a client of an arm that shows what its connection does to it.

#include <suture/component/channel/channel.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <atomic>

#include "reference/arm_like.suture.h"

namespace suture {

/// Asks its arm to hold still in every cycle, until it is told not to.
struct Operator final : PeriodicTask {
  Operator() : PeriodicTask({.period = std::chrono::milliseconds(5)}) {
    arm.on().stopped([this] { ++heard; });
  }
  ~Operator() override { stop(); }

  void run() override {
    if (const double speed = limit.exchange(-1); speed >= 0) {
      (void)arm.limit(speed, reference::Mode::Enabled);
    }
    if (resets.exchange(0) != 0) {
      arm.reset.start().then([this](const Result<std::uint32_t>& counted) {
        if (counted) answer = *counted;
        resetEnd = counted ? Errc{} : counted.error();
      });
    }
    if (!asks) {
      error = arm.unusable();
      return;
    }
    const auto held = arm.hold();
    error = held ? Errc{} : held.error();
  }

  Required<reference::ArmLike> arm{*this, "Arm"};
  std::atomic<bool> asks{true};
  std::atomic<Errc> error{Errc::NotYet};
  std::atomic<int> heard{0};
  std::atomic<int> resets{0};                ///< 1: to be asked for once
  std::atomic<Errc> resetEnd{Errc::NotYet};  ///< how that ended
  std::atomic<std::uint32_t> answer{0};
  std::atomic<double> limit{-1};  ///< the arm is asked for it once; negative: nothing
};

}  // namespace suture
