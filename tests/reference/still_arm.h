#pragma once
// This is an arm that does nothing but count.

#include <atomic>
#include <string>

#include "reference/arm_like.suture.h"

namespace suture {

class StillArm : public reference::ArmLike {
 public:
  void servo_cp(const reference::PoseStamped&) override {}
  void servo_jp(const reference::JointState&) override {}
  void hold() override { ++holds; }
  void set_mode(reference::Mode) override {}
  reference::PoseStamped measured_cp() const override { return pose; }
  const reference::JointState& measured_js() const override { return joints; }
  double distance(const reference::PoseStamped&) const override { return 0; }
  bool move(const reference::PoseStamped&, double, const std::string&) override { return false; }
  std::uint32_t reset() override { return 0; }
  void limit(double, reference::Mode) override {}

  std::atomic<int> holds{0};
  reference::PoseStamped pose;
  reference::JointState joints;
};

}  // namespace suture
