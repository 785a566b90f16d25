#include "surgeon/hand_path.h"

#include <numbers>

#include "arm_control/motion/smooth_step.h"

namespace robots {
namespace {

using Eigen::Array3d;
using Eigen::Vector3d;

// These are relative to the shape's amplitude, turn and frequency.
const Array3d kReach{1.0, 0.8, 0.6};
const Array3d kTurn{1.0, 0.7, 0.9};
const Array3d kReachFrequency{1.0, 0.743, 0.547};
const Array3d kTurnFrequency{0.931, 0.619, 0.867};

// It takes this many ramps to come to the centre.
constexpr double kReturn = 2;

Vector3d sines(const Array3d& frequency, double t) {
  return (2 * std::numbers::pi * frequency * t).sin().matrix();
}

}  // namespace

Eigen::Isometry3d HandPath::centreAt(double t) const {
  const double blend = smoothStep(t / (kReturn * shape_.ramp));
  const Eigen::Quaterniond from(start_.linear()), to(centre_.linear());
  Eigen::Isometry3d centre = Eigen::Isometry3d::Identity();
  centre.translation() =
      start_.translation() + blend * (centre_.translation() - start_.translation());
  centre.linear() = from.slerp(blend, to).toRotationMatrix();
  return centre;
}

Eigen::Isometry3d HandPath::at(double t) const {
  const double blend = smoothStep(t / shape_.ramp);
  const Vector3d offset =
      blend * shape_.amplitude *
      kReach.matrix().cwiseProduct(sines(shape_.frequency * kReachFrequency, t));
  const Vector3d rotation =
      blend * shape_.turn *
      kTurn.matrix().cwiseProduct(sines(shape_.frequency * kTurnFrequency, t));
  Eigen::Isometry3d hand = centreAt(t);
  hand.translation() += offset;
  const double angle = rotation.norm();
  if (angle > 0) {
    hand.linear() = Eigen::AngleAxisd(angle, rotation / angle) * hand.linear();
  }
  return hand;
}

double HandPath::maxSpeed() const {
  const Array3d swing = 2 * std::numbers::pi * shape_.frequency * kReachFrequency;
  const Array3d fade = Array3d::Constant(kSmoothStepPeakSlope / shape_.ramp);
  const double distance = (centre_.translation() - start_.translation()).norm();
  return shape_.amplitude * (kReach * (swing + fade)).matrix().norm() +
         distance * kSmoothStepPeakSlope / (kReturn * shape_.ramp);
}

}  // namespace robots
