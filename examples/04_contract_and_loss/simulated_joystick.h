#pragma once
// This is the provider. It simulates somebody who turns the stick slowly and steadily.

#include <suture/annotate.h>
#include <suture/component/task/periodic_task.h>

#include <chrono>

#include "04_contract_and_loss/joystick.suture.h"

namespace following {

class SUTURE_COMPONENT() SimulatedJoystick final : public suture::PeriodicTask, public Joystick {
 public:
  SimulatedJoystick() : PeriodicTask({.period = std::chrono::milliseconds(10)}) {}

  double angle() const override { return angle_; }
  void run() override { angle_ += 0.001; }

 private:
  double angle_ = 0.5;  // rad
  suture::Provided<Joystick> joystick_{*this, "Joystick", *this};
};

}  // namespace following
