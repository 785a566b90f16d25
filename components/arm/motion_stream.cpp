#include "arm/motion_stream.h"

#include <Eigen/Geometry>
#include <chrono>

#include "arm/kinematics/inverse.h"

namespace robots {

using kinematics::rotated;
using kinematics::SpatialVector;

constexpr suture::Duration kStreamSilence = std::chrono::milliseconds(100);

template <int N>
void MotionStream<N>::begin(Kind kind, std::string_view activity) {
  kind_ = kind;
  activity_ = activity;
  force_.reset();
  asked_ = true;
}

template <int N>
void MotionStream<N>::follow(const Joints& rate, std::string_view activity) {
  begin(Kind::JointRate, activity);
  rate_ = rate;
}

template <int N>
void MotionStream<N>::follow(Kind kind, const SpatialVector& twist, std::string_view activity,
                             const std::optional<SpatialVector>& force) {
  begin(kind, activity);
  twist_ = twist;
  force_ = force;
}

template <int N>
void MotionStream<N>::end() {
  kind_ = Kind::None;
  force_.reset();
}

template <int N>
bool MotionStream<N>::hasFallenSilent(suture::Time now) {
  if (asked_) lastAsked_ = now;
  asked_ = false;
  return isActive() && kind_ != Kind::Free && now - lastAsked_ > kStreamSilence;
}

template <int N>
std::optional<typename MotionStream<N>::Joints> MotionStream<N>::next(
    const kinematics::Chain<N>& chain, const Joints& setpoint, const Joints& measured,
    double dt) const {
  switch (kind_) {
    case Kind::None: return setpoint;
    case Kind::Free: return measured;
    case Kind::JointRate: return chain.clamp(setpoint + dt * rate_);
    case Kind::BodyTwist:
    case Kind::SpatialTwist: break;
  }
  return nextByTwist(chain, setpoint, dt);
}

template <int N>
std::optional<typename MotionStream<N>::Joints> MotionStream<N>::nextByTwist(
    const kinematics::Chain<N>& chain, const Joints& setpoint, double dt) const {
  Eigen::Isometry3d pose = chain.forward(setpoint);
  const SpatialVector twist = kind_ == Kind::BodyTwist ? rotated(pose.linear(), twist_) : twist_;
  const Eigen::Vector3d angle = dt * twist.template tail<3>();
  pose.translation() += dt * twist.template head<3>();
  if (angle.norm() > 0) {
    pose.linear() = Eigen::AngleAxisd(angle.norm(), angle.normalized()) * pose.linear();
  }
  const auto solution = kinematics::inverse(chain, pose, setpoint);
  if (!solution.found) return std::nullopt;
  return solution.q;
}

template <int N>
SpatialVector MotionStream<N>::twist(const Eigen::Matrix<double, 6, N>& jacobian,
                                     const Eigen::Matrix3d& tip) const {
  switch (kind_) {
    case Kind::JointRate: return jacobian * rate_;
    case Kind::BodyTwist: return rotated(tip, twist_);
    case Kind::SpatialTwist: return twist_;
    case Kind::None:
    case Kind::Free: break;
  }
  return SpatialVector::Zero();
}

template <int N>
SpatialVector MotionStream<N>::bodyForce(const Eigen::Matrix3d& tip) const {
  const SpatialVector force = force_.value_or(SpatialVector::Zero());
  return kind_ == Kind::BodyTwist ? force : rotated(tip.transpose(), force);
}

template <int N>
SpatialVector MotionStream<N>::spatialForce(const Eigen::Matrix3d& tip) const {
  const SpatialVector force = force_.value_or(SpatialVector::Zero());
  return kind_ == Kind::BodyTwist ? rotated(tip, force) : force;
}

template class MotionStream<6>;
template class MotionStream<7>;

}  // namespace robots
