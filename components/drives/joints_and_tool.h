#pragma once
// This puts the joints of an arm and, behind them, the joint of its tool into one set of joints.

#include <memory>
#include <utility>

#include "drives/simulated_joints.h"

namespace robots {

/// One thread; only the constructor allocates.
template <int N>
class JointsAndTool final : public SimulatedJoints<N + 1> {
 public:
  using Joints = typename SimulatedJoints<N + 1>::Joints;

  /// The joint of the tool is shared with what else acts on it, in the same thread.
  JointsAndTool(std::unique_ptr<SimulatedJoints<N>> joints,
                std::shared_ptr<SimulatedJoints<1>> tool)
      : joints_(std::move(joints)), tool_(std::move(tool)) {
    measure();
  }

  void advance(double dt) override {
    joints_->advance(dt);
    tool_->advance(dt);
    measure();
  }
  void command(const Joints& setpoint) override {
    joints_->command(setpoint.template head<N>());
    tool_->command(setpoint.template tail<1>());
  }
  void order(const MotorOrder<N + 1>& order) override {
    joints_->order({.effort = order.effort.template head<N>(),
                    .released = order.released.template head<N>(),
                    .compensation = order.compensation});
  }
  void brake() override {
    joints_->brake();
    tool_->brake();
  }

  const Joints& measured() const override { return measured_; }
  Joints velocity() const override { return together(joints_->velocity(), tool_->velocity()); }
  Joints effort() const override { return together(joints_->effort(), tool_->effort()); }
  bool measuresEffort() const override { return joints_->measuresEffort(); }

 private:
  static Joints together(const typename SimulatedJoints<N>::Joints& joints,
                         const SimulatedJoints<1>::Joints& tool) {
    Joints all;
    all << joints, tool;
    return all;
  }
  void measure() { measured_ = together(joints_->measured(), tool_->measured()); }

  std::unique_ptr<SimulatedJoints<N>> joints_;
  std::shared_ptr<SimulatedJoints<1>> tool_;
  Joints measured_;
};

}  // namespace robots
