#include "05_events/simulated_gripper.h"

#include <chrono>

namespace gripping {

SimulatedGripper::SimulatedGripper() : PeriodicTask({.period = std::chrono::milliseconds(50)}) {}

// Emits the state from the start on, although nobody may have subscribed yet, because it is
// latched.
void SimulatedGripper::onStart() { become(Jaws::Open); }

void SimulatedGripper::grasp() {
  touches_ = 0;
  become(Jaws::Closing);
}

bool SimulatedGripper::release() {
  const bool held = jaws_ == Jaws::Holding;
  become(Jaws::Open);
  return held;
}

void SimulatedGripper::run() {
  constexpr int kTouches = 3;
  constexpr double kForceOfTouch = 0.5;  // N, more with each
  if (jaws_ != Jaws::Closing) return;
  if (touches_ == kTouches) return become(Jaws::Holding);
  ++touches_;
  (void)gripper_.emit().touched(kForceOfTouch * touches_);
}

void SimulatedGripper::become(Jaws jaws) {
  jaws_ = jaws;
  (void)gripper_.emit().jaws_changed(jaws);
}

}  // namespace gripping
