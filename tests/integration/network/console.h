#pragma once
// This is the client of these tests.

#include <suture/component/device.h>

#include <string>
#include <vector>

#include "integration/network/arm.h"
#include "support/contains.h"
#include "support/eventually.h"

namespace suture {

struct Console final : Device {
  Console() {
    arm.on().mode([this](const reference::Mode& mode) { modes.push_back(mode); });
  }
  Required<reference::ArmLike> arm{*this, "Arm"};
  std::vector<reference::Mode> modes;
};

inline reference::PoseStamped poseAt(double x) {
  reference::PoseStamped pose;
  pose.pose.translation().x() = x;
  pose.stamp = now();
  pose.valid = true;
  return pose;
}

/// The arm goes where it is sent, and is read there.
inline bool reaches(Console& console, double x) {
  return console.arm.servo_cp.start(poseAt(x)).within(std::chrono::seconds(5)).has_value() &&
         eventually([&] {
           const auto pose = console.arm.measured_cp();
           return pose && pose->pose.translation().x() == x;
         });
}

}  // namespace suture
