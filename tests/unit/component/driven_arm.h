#pragma once
// This is a task whose cycles the test itself runs, with one automatic and one manual state table.

#include <suture/component/own_state.h>
#include <suture/component/task/task.h>

#include <functional>
#include <string>

#include "reference/still_arm.h"
#include "support/pass.h"

namespace suture {

/// Its pose and its only joint both count evaluations of the pose.
class CountingArm : public StillArm {
 public:
  reference::PoseStamped measured_cp() const override {
    pose_.pose.translation().x() += 1;
    joints_.position.assign(1, pose_.pose.translation().x());
    return pose_;
  }
  const reference::JointState& measured_js() const override { return joints_; }

 private:
  mutable reference::PoseStamped pose_;
  mutable reference::JointState joints_;
};

/// Driven by the test, which is its thread: cycle after cycle.
class DrivenArm final : public Task {
 public:
  void start() override {
    prepare();
    enter();
  }
  void stop() override { leave(); }
  /// Each cycle begins later than the one before, on a stepped clock too.
  void cycle() {
    pass(std::chrono::microseconds(1));
    Task::cycle();
    pass(std::chrono::microseconds(1));
  }

  CountingArm automatic, manual;
  Provided<reference::ArmLike> automaticPort{*this, "Automatic", automatic};
  Provided<reference::ArmLike> manualPort{*this, "Manual", manual};
  OwnState<reference::ArmLike> past{automaticPort};
  std::function<void()> work = [] {};

 private:
  void run() override { work(); }
};

}  // namespace suture
