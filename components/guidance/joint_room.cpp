#include "guidance/joint_room.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace robots {
namespace {

using JacobianMatrix = Eigen::Matrix<double, 6, kTipJoints>;

// This damps the inverse near a singularity, where joints would seem to move without end. Elsewhere
// it changes the result by less than the error of treating the step as linear.
constexpr double kDamping = 1e-3;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Returns the entries of a list that may be left out.
TipJoints listed(const std::vector<double>& list, double otherwise) {
  TipJoints joints = TipJoints::Constant(otherwise);
  if (list.size() == std::size_t{kTipJoints}) joints = TipJoints::Map(list.data());
  return joints;
}

/// Returns how the joints move as the tip moves (three columns) and turns (three columns).
Eigen::Matrix<double, kTipJoints, 6> inverseOf(const JacobianMatrix& jacobian) {
  Eigen::Matrix<double, 6, 6> square = jacobian * jacobian.transpose();
  square.diagonal().array() += kDamping * kDamping;
  return square.llt().solve(jacobian).transpose();
}

}  // namespace

std::optional<JointBounds> jointBounds(const JointConfiguration& configuration) {
  if (configuration.name.size() != std::size_t{kTipJoints}) return std::nullopt;
  const TipJoints slowest = listed(configuration.velocity_max, kInfinity)
                                .cwiseMin(-listed(configuration.velocity_min, -kInfinity));
  return JointBounds{listed(configuration.position_min, -kInfinity),
                     listed(configuration.position_max, kInfinity), slowest};
}

double turnShare(const JointBounds& bounds, const JointState& setpoint, const Jacobian& jacobian,
                 const TipAhead& ahead, double seconds) {
  const auto inverse = inverseOf(JacobianMatrix::Map(jacobian.coefficients.data()));
  const TipJoints turn = inverse.rightCols<3>() * ahead.turns;
  const TipJoints before = TipJoints::Map(setpoint.position.data()) +
                           inverse.leftCols<3>() * ahead.moved +
                           inverse.rightCols<3>() * (ahead.turned - ahead.turns);
  double share = 1;
  for (int joint = 0; joint < kTipJoints; ++joint) {
    const bool up = turn[joint] > 0;
    const double left =
        up ? bounds.upper[joint] - before[joint] : before[joint] - bounds.lower[joint];
    const double room = std::clamp(left, 0.0, seconds * bounds.rate[joint]);
    if (std::abs(turn[joint]) > room) share = std::min(share, room / std::abs(turn[joint]));
  }
  return share;
}

JointRoom jointRoom(const JointBounds& bounds, const JointState& setpoint, const Jacobian& jacobian,
                    const TipAhead& ahead, const Eigen::Matrix3d& base, double seconds) {
  const auto inverse = inverseOf(JacobianMatrix::Map(jacobian.coefficients.data()));
  const auto moving = inverse.leftCols<3>(), turning = inverse.rightCols<3>();
  const TipJoints here =
      TipJoints::Map(setpoint.position.data()) + moving * ahead.moved + turning * ahead.turned;
  const TipJoints turn = turning * ahead.turns, farthest = seconds * bounds.rate;
  JointRoom room;
  room.motion = moving * base.transpose();
  room.least = (bounds.lower - here).cwiseMax(-farthest - turn);
  room.most = (bounds.upper - here).cwiseMin(farthest - turn);
  return room;
}

}  // namespace robots
