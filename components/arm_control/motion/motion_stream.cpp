#include "arm_control/motion/motion_stream.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "arm_control/motion/shortened.h"

namespace robots {

using kinematics::rotated;
using kinematics::SpatialVector;

template <int N>
void MotionStream<N>::release(std::string_view activity) {
  begin(Kind::Free, activity);
  order_ = {.released = Mask::Constant(true)};
}

template <int N>
void MotionStream<N>::push(const Joints& effort, const Mask& released, std::string_view activity) {
  begin(Kind::JointEffort, activity);
  order_ = {.effort = effort, .released = released};
}

template <int N>
void MotionStream<N>::push(Kind kind, const SpatialVector& wrench, std::string_view activity) {
  begin(kind, activity);
  order_ = {.released = Mask::Constant(true)};
  wrench_ = wrench;
}

template <int N>
void MotionStream<N>::begin(Kind kind, std::string_view activity) {
  if (kind != kind_) end();
  kind_ = kind;
  activity_ = activity;
  if (kind != Kind::Free) watch_.ask();
}

template <int N>
void MotionStream<N>::follow(const Joints& rate, std::string_view activity,
                             const JointBounds& bounds) {
  begin(Kind::JointRate, activity);
  rate_.aimAt(rate, bounds.change);
  guard_ = bounds.guard;
}

template <int N>
void MotionStream<N>::follow(Kind kind, const SpatialVector& twist, std::string_view activity,
                             const TwistBounds& bounds) {
  if (!bounds.axes.isApprox(axes_)) end();  // its speed is along the previous axes
  begin(kind, activity);
  twist_.aimAt(twist, bounds.change);
  axes_ = bounds.axes;
}

template <int N>
void MotionStream<N>::end() {
  kind_ = Kind::None;
  watch_.end();
  rate_.stop();
  twist_.stop();
  order_ = {};
}

template <int N>
std::optional<typename MotionStream<N>::Step> MotionStream<N>::next(
    const kinematics::Chain<N>& chain, kinematics::InverseFunction<N> inverse,
    const Joints& setpoint, const Joints& measured, double dt) {
  switch (kind_) {
    case Kind::None: return Step{setpoint};
    case Kind::Free:
    case Kind::JointEffort:
    case Kind::BodyWrench:
    case Kind::SpatialWrench: return Step{order_.released.select(measured, setpoint)};
    case Kind::JointRate: break;
    case Kind::BodyTwist:
    case Kind::SpatialTwist: return nextByTwist(chain, inverse, setpoint, dt);
  }
  const Joints next = nextByRate(setpoint, dt);
  return Step{chain.clamp(next), !chain.within(next)};
}

template <int N>
typename MotionStream<N>::Joints MotionStream<N>::nextByRate(const Joints& setpoint, double dt) {
  Joints next = setpoint + dt * rate_.advance(dt);
  if (!guard_) return next;
  for (int i = 0; i < N; ++i) {
    const double guard = (*guard_)[i];
    if (setpoint[i] <= guard) next[i] = std::min(next[i], guard);
    if (setpoint[i] >= guard) next[i] = std::max(next[i], guard);
  }
  return next;
}

template <int N>
std::optional<typename MotionStream<N>::Step> MotionStream<N>::nextByTwist(
    const kinematics::Chain<N>& chain, kinematics::InverseFunction<N> inverse,
    const Joints& setpoint, double dt) {
  Eigen::Isometry3d pose = chain.forward(setpoint);
  const SpatialVector along = rotated(axes_, twist_.advance(dt));
  const SpatialVector twist = kind_ == Kind::BodyTwist ? rotated(pose.linear(), along) : along;
  const Eigen::Vector3d angle = dt * twist.template tail<3>();
  pose.translation() += dt * twist.template head<3>();
  if (angle.norm() > 0) {
    pose.linear() = Eigen::AngleAxisd(angle.norm(), angle.normalized()) * pose.linear();
  }
  const auto solution = inverse(chain, pose, setpoint, kinematics::Postures::Near);
  if (!solution.found && !solution.limited) return std::nullopt;
  return Step{solution.q, solution.limited};
}

template <int N>
MotorOrder<N> MotionStream<N>::motors(const kinematics::Chain<N>& chain, const Joints& measured,
                                      const Joints& most) const {
  MotorOrder<N> order = order_;
  order.effort = order.effort.cwiseMax(-most).cwiseMin(most);
  if (!isWrench()) return order;
  const bool isOfBody = kind_ == Kind::BodyWrench;
  const SpatialVector wrench =
      isOfBody ? rotated(chain.forward(measured).linear(), wrench_) : wrench_;
  order.effort = shortened<Joints>(chain.jacobian(measured).transpose() * wrench, most);
  return order;
}

template class MotionStream<6>;
template class MotionStream<7>;

}  // namespace robots
