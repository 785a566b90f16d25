#pragma once
// These drives measure what a test says.

#include <suture/component/provided.h>
#include <suture/component/task/periodic_task.h>

#include <atomic>
#include <chrono>

#include "drives/drives.suture.h"
#include "drives/simulated_drives.h"

namespace robots::test {

/// Any thread may set both. Drives of a PSM: the first joint jumps by `jump` rad and its motor
/// gives `effort` N.m.
class PlantedDrives final : public suture::PeriodicTask, public SimulatedDrives<7> {
 public:
  PlantedDrives()
      : PeriodicTask({.period = std::chrono::milliseconds(1)}),
        SimulatedDrives({.lower = Joints::Constant(-1),
                         .upper = Joints::Constant(1),
                         .parked = Joints::Constant(0.1),
                         .rate_limit = Joints::Constant(4),
                         .time_constant = 0.01}) {}

  const DriveFeedback& feedback() const override {
    told_ = SimulatedDrives::feedback();
    told_.position[0] += jump;
    told_.effort[0] += effort;
    return told_;
  }

  std::atomic<double> jump{0}, effort{0};

 private:
  void run() override {
    permit(true);
    step(suture::now());
    announce(drives_.emit());
  }

  mutable DriveFeedback told_;
  suture::Provided<Drives> drives_{*this, "Drives", *this};
};

}  // namespace robots::test
