#pragma once
// This has the pedals and the viewer, which a test operates in place of a person.

#include <suture/component/provided.h>
#include <suture/component/task/periodic_task.h>

#include <atomic>
#include <chrono>

#include "pedals/foot_pedals.suture.h"
#include "pedals/operator_presence.suture.h"

namespace robots::test {

/// Any thread may set its public variables.
class TestConsole final : public suture::PeriodicTask, public FootPedals, public OperatorPresence {
 public:
  TestConsole() : PeriodicTask({.period = std::chrono::milliseconds(5)}) {}
  ~TestConsole() override { stop(); }

  PedalState pedals() const override { return {clutch, camera, false, stamp_}; }
  Presence presence() const override { return {present, stamp_}; }
  void run() override {
    if (!stuck) stamp_ = suture::now() + std::chrono::milliseconds(ahead);
  }

  std::atomic<bool> clutch = false, camera = false, present = true, stuck = false;
  std::atomic<int> ahead = 0;  // ms, by which its clock is wrong

 private:
  suture::Time stamp_;
  suture::Provided<FootPedals> pedalPort_{*this, "Pedals", *this};
  suture::Provided<OperatorPresence> presencePort_{*this, "Presence", *this};
};

}  // namespace robots::test
