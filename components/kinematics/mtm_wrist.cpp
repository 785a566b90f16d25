#include "kinematics/mtm_wrist.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "kinematics/davinci_links.h"
#include "kinematics/turns.h"

namespace robots::kinematics {
namespace {

constexpr int kPlatform = 3, kPitch = 4, kYaw = 5, kRoll = 6;  // in the chain

// Returns how the four joints move with the platform while the tool keeps its orientation.
Eigen::Vector4d selfMotion(const Eigen::Vector4d& q) {
  const double pitchSine = std::sin(q[1]);
  const double yawCosine = std::cos(q[2]);
  return {1, -pitchSine * std::tan(q[2]), -std::cos(q[1]), pitchSine / yawCosine};
}

}  // namespace

// Holds the platform angles at which a joint reaches a limit, including the platform's own: in
// ascending order they separate admissible angles from the others.
class MtmWrist::Boundaries {
 public:
  Boundaries(double lower, double upper) : lower_(lower), upper_(upper) {
    for (const double limit : {lower, upper}) angles_[count_++] = limit;
  }
  void add(double angle) {
    const double turned = nearestTurn(angle, lower_, lower_, upper_);
    if (turned < lower_ || turned > upper_) return;
    angles_[count_++] = turned;
  }
  std::span<const double> inOrder() {
    std::sort(angles_.begin(), angles_.begin() + count_);
    return {angles_.data(), count_};
  }

 private:
  static constexpr std::size_t kMost =
      4 + 4 + 4 + 2;  // the platform's, wrist yaw's, wrist pitch's, the roll's
  std::array<double, kMost> angles_;
  std::size_t count_ = 0;
  double lower_, upper_;
};

MtmWrist::MtmWrist(const Chain<7>& chain, const Eigen::Matrix3d& orientation,
                   const Chain<7>::Joints& start)
    : chain_(chain), start_(start), orientation_(orientation) {
  const Eigen::Vector3d axis = orientation.col(2);
  heading_ = std::atan2(axis.y(), axis.x());
  tilt_ = std::hypot(axis.x(), axis.y());
  height_ = axis.z();
}

MtmWrist::Joints MtmWrist::at(double platform) const {
  const double sine = std::sin(platform), cosine = std::cos(platform);
  // This is the axis of the wrist pitch, and how the wrist turns about it.
  const Eigen::RowVector3d pitchAxis = sine * orientation_.row(0) - cosine * orientation_.row(1);
  const double along = orientation_(0, 2) * cosine + orientation_(1, 2) * sine;
  Joints q;
  q[0] = platform;
  q[1] = std::atan2(-height_, -along);
  q[2] = std::atan2(pitchAxis[2], std::hypot(along, height_));
  q[3] = std::atan2(-pitchAxis[1], pitchAxis[0]) - kHalfPi;
  for (const int i : {1, 3}) {
    const int joint = kPlatform + i;
    q[i] = nearestTurn(q[i], start_[joint], chain_.lower()[joint], chain_.upper()[joint]);
  }
  return q;
}

bool MtmWrist::isWithin(const Joints& q) const {
  return (q.array() >= chain_.lower().tail<4>().array() - kLimitSlack).all() &&
         (q.array() <= chain_.upper().tail<4>().array() + kLimitSlack).all();
}

// The sine of the wrist yaw is the tilt times the sine of the angle from the heading to the
// platform. The tangent of the wrist pitch is the height divided by the tilt times the cosine of
// that angle.
MtmWrist::Boundaries MtmWrist::boundaries() const {
  Boundaries boundaries(chain_.lower()[kPlatform], chain_.upper()[kPlatform]);
  for (const double limit : {chain_.lower()[kYaw], chain_.upper()[kYaw]}) {
    const double sine = std::sin(limit) / tilt_;
    if (!(std::abs(sine) <= 1)) continue;
    boundaries.add(heading_ + std::asin(sine));
    boundaries.add(heading_ + std::numbers::pi - std::asin(sine));
  }
  for (const double limit : {chain_.lower()[kPitch], chain_.upper()[kPitch]}) {
    const double cosine = height_ * std::cos(limit) / (tilt_ * std::sin(limit));
    const bool isOpposite = height_ * std::sin(limit) > 0;
    if (isOpposite || !(std::abs(cosine) <= 1)) continue;
    boundaries.add(heading_ + std::acos(cosine));
    boundaries.add(heading_ - std::acos(cosine));
  }
  for (const double limit : {chain_.lower()[kRoll], chain_.upper()[kRoll]}) {
    // Other turns remain beyond a limit, so a limit is a boundary only if the start is on its turn.
    if (std::abs(limit - start_[kRoll]) < std::numbers::pi) boundaries.add(platformForRoll(limit));
  }
  return boundaries;
}

// Returns the platform angle for a roll: at this roll the tool's axes have turned so far that one
// of them lies in the plane of the axes of platform and roll.
double MtmWrist::platformForRoll(double roll) const {
  const Eigen::Vector3d inPlane =
      std::cos(roll) * orientation_.col(0) - std::sin(roll) * orientation_.col(1);
  return height_ > 0 ? std::atan2(inPlane.y(), inPlane.x())
                     : std::atan2(-inPlane.y(), -inPlane.x());
}

// Between two neighbouring boundaries either all angles are admissible or none. If none is
// admissible between any two, a boundary itself may be.
std::optional<MtmWrist::Range> MtmWrist::nearestRange() const {
  std::optional<Range> nearest;
  double distance = std::numeric_limits<double>::infinity();
  const auto consider = [&](const Range& range) {
    if (!isWithin(at(0.5 * (range.lower + range.upper)))) return;
    const Joints q = at(std::clamp(start_[kPlatform], range.lower, range.upper));
    const double moved = (q - start_.tail<4>()).squaredNorm();
    if (moved >= distance) return;
    nearest = range;
    distance = moved;
  };
  Boundaries all = boundaries();
  const std::span<const double> angles = all.inOrder();
  for (std::size_t i = 1; i < angles.size(); ++i) consider({angles[i - 1], angles[i]});
  if (nearest) return nearest;
  for (const double angle : angles) consider({angle, angle});
  return nearest;
}

// Makes Gauss-Newton steps along the self-motion; a step that does not come nearer is halved.
std::optional<MtmWrist::Joints> MtmWrist::nearest() const {
  constexpr int kSteps = 8;
  constexpr double kSmallestStep = 1e-10;  // rad
  const std::optional<Range> range = nearestRange();
  if (!range) return std::nullopt;
  const Joints start = start_.tail<4>();
  Joints q = at(std::clamp(start[0], range->lower, range->upper));
  double share = 1;
  for (int i = 0; i < kSteps; ++i) {
    const Joints motion = selfMotion(q);
    const double step = motion.dot(start - q) / motion.squaredNorm();
    const double platform = std::clamp(q[0] + share * step, range->lower, range->upper);
    if (std::abs(platform - q[0]) <= kSmallestStep) break;
    const Joints next = at(platform);
    if ((next - start).squaredNorm() < (q - start).squaredNorm()) {
      q = next;
    } else {
      share *= 0.5;
    }
  }
  return q;
}

}  // namespace robots::kinematics
