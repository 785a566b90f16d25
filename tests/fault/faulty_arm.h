#pragma once
// This is an arm that hangs for as long as a file exists.

#include <suture/component/task/event_task.h>
#include <suture/component/task/periodic_task.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

#include "reference/arm_like.suture.h"

namespace reference {

/// The arm is where it was last sent to. limit() makes its next run() hang; with a speed, without
/// sleeping.
template <class Kind>
class FaultyArm final : public Kind, public ArmLike {
 public:
  template <class... Options>
  explicit FaultyArm(std::string file, const Options&... options)
      : Kind(options...), file_(std::move(file)) {}

  void servo_cp(const PoseStamped& goal) override { measured_ = goal; }
  void servo_jp(const JointState&) override {}
  void hold() override { arm_.emit().stopped(); }
  void set_mode(Mode mode) override { arm_.emit().mode(mode); }
  PoseStamped measured_cp() const override { return measured_; }
  const JointState& measured_js() const override { return joints_; }
  double distance(const PoseStamped&) const override { return 0; }
  bool move(const PoseStamped&, double, const std::string&) override { return true; }
  std::uint32_t reset() override { return ++resets_; }
  void limit(double speed, Mode) override {
    hangs_ = true;
    spins_ = speed > 0;
  }

 private:
  void run() override {
    while (hangs_ && access(file_.c_str(), F_OK) == 0) {
      if (!spins_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    hangs_ = false;
  }

  const std::string file_;
  bool hangs_ = false, spins_ = false;
  std::uint32_t resets_ = 0;
  PoseStamped measured_;
  JointState joints_;
  suture::Provided<ArmLike> arm_{*this, "Arm", *this};
};

}  // namespace reference
