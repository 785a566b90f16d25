#pragma once
// This measures by how much the picture lags behind the masters, where an operator sits.

#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <Eigen/Geometry>
#include <atomic>
#include <chrono>
#include <optional>

#include "arm/arm.suture.h"
#include "timing/seconds.h"
#include "vision/knot_vision.suture.h"

namespace robots::test {

/// Moves both masters evenly, and compares with what is in the picture: the time from a motion of
/// the masters until it is seen is the loop's own delay. Requires what an operator requires of arms
/// and picture.
class LagProbe final : public suture::PeriodicTask {
 public:
  /// `scale` is how far the knot moves for a metre of both masters. `moved` is the direction in
  /// which it moves them, in their base frames, and `seen` that direction in the camera's frame;
  /// both are unit vectors.
  explicit LagProbe(double scale, const Eigen::Vector3d& moved = Eigen::Vector3d::UnitX(),
                    const Eigen::Vector3d& seen = Eigen::Vector3d::UnitX())
      : PeriodicTask({.period = std::chrono::milliseconds(1)}),
        scale_(scale),
        moved_(moved),
        seen_(seen) {}

  /// Any thread may call it once arms and picture are ready, and the knot is at rest.
  void begin() { begun_ = true; }
  /// The measurement is done so long after begin().
  static constexpr suture::Duration kTakes = std::chrono::seconds(4);

  /// s, the mean over whole pictures. While the task does not run.
  double lag() const { return sum_ / count_; }

 private:
  static constexpr double kSpeed = 0.02;  // m/s, of the masters
  static constexpr double kSettled = 1;   // s
  static constexpr int kCycles = 2000;    // 30 pictures

  void run() override {
    const auto sighting = vision_.sighting();
    if (!begun_ || !sighting || !sighting->valid) return;
    const suture::Time now = suture::now();
    if (!start_ && !setOut(now, *sighting)) return;
    const double t = secondsBetween(start_->at, now);
    const Eigen::Translation3d offset(kSpeed * t * moved_);
    left_.servo_cp({offset * start_->left, now, true});
    right_.servo_cp({offset * start_->right, now, true});
    if (t < kSettled || count_ == kCycles) return;
    sum_ += t - seen_.dot(sighting->knot - start_->knot) / (scale_ * kSpeed);
    ++count_;
  }

  bool setOut(suture::Time now, const KnotSighting& sighting) {
    const auto left = left_.setpoint_cp(), right = right_.setpoint_cp();
    if (!left || !right) return false;
    start_ = Start{left->pose, right->pose, sighting.knot, now};
    return true;
  }

  suture::Required<Arm> left_{*this, "Left"}, right_{*this, "Right"};
  suture::Required<KnotVision> vision_{*this, "Vision"};
  const double scale_;
  const Eigen::Vector3d moved_, seen_;
  std::atomic<bool> begun_ = false;
  struct Start {
    Eigen::Isometry3d left, right;
    Eigen::Vector3d knot;  // m, in the camera's frame
    suture::Time at;
  };
  std::optional<Start> start_;
  double sum_ = 0;
  int count_ = 0;
};

}  // namespace robots::test
