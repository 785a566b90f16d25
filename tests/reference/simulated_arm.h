#pragma once
// A component with parameters.

#include <suture/annotate.h>
#include <suture/component/task/periodic_task.h>

#include <array>
#include <string>

#include "reference/arm_like.h"
#include "reference/arm_like.suture.h"

namespace reference {

/// Parameters of SimulatedArm.
struct SUTURE_TYPE() SimulatedArmParameters {
  SUTURE_FIELD(unit("s"), range(0.0001, 1)) double period = 0.001;
  SUTURE_FIELD(unit("m")) std::array<double, 3> home = {0, 0, 0};
  std::string model;
};

/// The arm is where it was last sent to.
class SUTURE_COMPONENT() SimulatedArm final : public suture::PeriodicTask, public ArmLike {
 public:
  explicit SimulatedArm(const SimulatedArmParameters& parameters)
      : PeriodicTask({.period = std::chrono::duration_cast<suture::Duration>(
                          std::chrono::duration<double>(parameters.period))}) {
    measured_.pose.translation() << parameters.home[0], parameters.home[1], parameters.home[2];
  }

  void servo_cp(const PoseStamped& goal) override { measured_ = goal; }
  void servo_jp(const JointState& goal) override { joints_ = goal; }
  void hold() override { arm_.emit().stopped(); }
  void set_mode(Mode mode) override { arm_.emit().mode(mode); }
  PoseStamped measured_cp() const override { return measured_; }
  const JointState& measured_js() const override { return joints_; }
  double distance(const PoseStamped& to) const override {
    return (measured_.pose.translation() - to.pose.translation()).norm();
  }
  bool move(const PoseStamped& goal, double speed, const std::string&) override {
    measured_ = goal;
    return speed > 0;
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
