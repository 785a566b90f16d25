#include "06_one_arm/motion_display.h"

#include <array>
#include <chrono>
#include <cstdio>

namespace watching {

using robots::TeleopState;

MotionDisplay::MotionDisplay() : PeriodicTask({.period = std::chrono::milliseconds(500)}) {}

void MotionDisplay::run() {
  const auto state = teleoperation_.teleop_state();
  if (!state) return print(std::string("teleoperation: ") + suture::toString(state.error()));
  if (*state == TeleopState::Disabled) return print("teleoperation is disabled");
  const auto master = tipOf(master_), slave = tipOf(slave_);
  if (!master || !slave) return;
  if (*state == TeleopState::Preparing) return print("the arms are being prepared");
  if (*state == TeleopState::Aligning) return print("the master is being aligned");
  if (*state == TeleopState::Clutched) return print("the slave holds");
  const auto anchors = teleoperation_.anchors();
  if (!anchors) return;
  if (!began_ || anchors->entry != entry_) began_ = {*master, *slave};
  entry_ = anchors->entry;
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "master moved by %5.1f mm, slave by %5.1f mm",
                1e3 * (*master - began_->master).norm(), 1e3 * (*slave - began_->slave).norm());
  print(text.data());
}

std::optional<Eigen::Vector3d> MotionDisplay::tipOf(suture::Required<robots::Arm>& arm) {
  const auto pose = arm.measured_cp();
  if (pose && pose->valid) return pose->pose.translation();
  print(arm.name() + ": " +
        (pose ? "it does not know where its tip is" : suture::toString(pose.error())));
  return std::nullopt;
}

// Printing may take its time, and nothing waits for this task.
void MotionDisplay::print(const std::string& text) const {
  std::printf("%s: %s\n", name().c_str(), text.c_str());
  std::fflush(stdout);
}

}  // namespace watching
