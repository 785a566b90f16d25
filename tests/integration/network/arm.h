#pragma once
// This is the arm of these tests: it is where it was last sent to.

#include <suture/component/task/event_task.h>

#include "reference/arm_like.suture.h"

namespace reference {

class HostedArm final : public suture::EventTask, public ArmLike {
 public:
  void servo_cp(const PoseStamped& goal) override { measured_ = goal; }
  void servo_jp(const JointState& goal) override { joints_ = goal; }
  void hold() override { arm_.emit().stopped(); }
  void set_mode(Mode mode) override { arm_.emit().mode(mode); }
  PoseStamped measured_cp() const override { return measured_; }
  const JointState& measured_js() const override { return joints_; }
  double distance(const PoseStamped& to) const override {
    return (measured_.pose.translation() - to.pose.translation()).norm();
  }
  bool move(const PoseStamped& goal, double, const std::string&) override {
    measured_ = goal;
    return true;
  }
  std::uint32_t reset() override { return 0; }
  void limit(double, Mode) override {}

 private:
  void run() override {}

  PoseStamped measured_;
  JointState joints_;
  suture::Provided<ArmLike> arm_{*this, "Arm", *this};
};

}  // namespace reference
