#pragma once
// Stands in for Provided<Arm>::emit().

#include <suture/standard/messages.h>

#include "robot_types/operating_state.h"

namespace robots::test {

/// Hears nothing. A test declares what it wants to hear in a class of its own that derives from it.
struct Deaf {
  void desired_state(ArmState) {}
  void operating_state(const OperatingState&) {}
  void goal_reached(bool) {}
  void gravity_compensation(bool) {}
  void trajectory_j_ratio(double) {}
  void trajectory_j_ratio_v(double) {}
  void trajectory_j_ratio_a(double) {}
  void status(const suture::Message&) {}
  void warning(const suture::Message&) {}
  void error(const suture::Message&) {}
};

}  // namespace robots::test
