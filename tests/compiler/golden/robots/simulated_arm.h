#pragma once
// This is a component with parameters.

#include <suture/annotate.h>
#include <suture/component/task/periodic_task.h>

#include <string>

#include "robots/arm.h"
#include "robots/arm.suture.h"

namespace robots {

/// How a simulated arm behaves.
struct SUTURE_TYPE() ArmParameters {
  SUTURE_FIELD(unit("Hz"), range(1, 4000)) double rate = 1000.0;
  std::string name;
  Mode start = Mode::Disabled;
};

/// The arm is where it was last sent to.
class SUTURE_COMPONENT() SimulatedArm final : public suture::PeriodicTask, public Arm {
 public:
  explicit SimulatedArm(const ArmParameters& parameters)
      : PeriodicTask(
            {.period = suture::Duration(static_cast<std::int64_t>(1e9 / parameters.rate))}),
        mode_(parameters.start) {}

  void enable() override { mode_ = Mode::HoldStill; }
  void servo_cp(const PoseStamped& goal) override { everything_.goal = goal; }
  void set_speed(double speed) override { everything_.speed = speed; }
  PoseStamped measured_cp() const override { return everything_.goal; }
  Mode mode() const override { return mode_; }
  const Everything& everything() const override { return everything_; }
  const Everything& inverse_kinematics(const PoseStamped&, double) const override {
    return everything_;
  }
  bool grasp(double width, Mode) override { return width > 0; }
  std::uint32_t next_token() override { return ++token_; }

 private:
  void run() override {}

  Mode mode_;
  std::uint32_t token_ = 0;
  Everything everything_;
  suture::Provided<Arm> arm_{*this, "Arm", *this};
};

}  // namespace robots
