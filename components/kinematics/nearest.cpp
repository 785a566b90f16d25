#include "kinematics/nearest.h"

#include <algorithm>
#include <cmath>

#include "kinematics/pose_error.h"
#include "kinematics/spatial_vector.h"
#include "kinematics/step_within_limits.h"

namespace robots::kinematics {
namespace {

// Near the goal each of Newton's steps is about the square of the one before, so after a step this
// small (rad or m) the next would change nothing.
constexpr double kLastStep = 1e-7;

// The search stands here.
template <int N>
struct Standpoint {
  typename Chain<N>::Joints q;
  typename Chain<N>::Posture posture;
  SpatialVector error;
  double cost;  // half the weighted square of the error

  Standpoint(const Chain<N>& chain, const Eigen::Isometry3d& goal,
             const typename Chain<N>::Joints& joints)
      : q(joints),
        posture(chain.posture(joints)),
        error(poseError(posture.tip, goal)),
        cost(0.5 * error.dot(poseWeights().cwiseProduct(error))) {}

  bool isAtGoal() const {
    constexpr InverseOptions tolerance;
    return error.head<3>().norm() <= tolerance.position_tolerance &&
           error.tail<3>().norm() <= tolerance.orientation_tolerance;
  }
};

// Holds what the curvature of a rotation's squared angle depends on: along the rotation's axis it
// is 1, across it `across`, which is (angle / 2) / tan(angle / 2).
struct RotationCurvature {
  double across;
  double along;  // (1 - across) / angle^2

  explicit RotationCurvature(double angle) {
    constexpr double kTiny = 1e-3;  // rad; from there down the series is exact to rounding
    if (angle < kTiny) {
      along = 1.0 / 12;
      across = 1 - along * angle * angle;
    } else {
      across = 0.5 * angle / std::tan(0.5 * angle);
      along = (1 - across) / (angle * angle);
    }
  }
};

// Returns the second derivatives of the cost by the joints. A joint turns or moves all that lies
// behind it, so that the tip's velocity by joint j changes by joint i <= j with axis_i x
// velocity_j.
template <int N>
Eigen::Matrix<double, N, N> curvatureOf(const Standpoint<N>& at) {
  constexpr double kPositionWeight = 1 / (kLengthScale * kLengthScale);
  const Eigen::Vector3d position = at.error.template head<3>(),
                        rotation = at.error.template tail<3>();
  const RotationCurvature turned(rotation.norm());
  Eigen::Matrix<double, N, N> curvature;
  for (int i = 0; i < N; ++i) {
    const Eigen::Vector3d velocity = at.posture.jacobian.col(i).template head<3>();
    const Eigen::Vector3d axis = at.posture.jacobian.col(i).template tail<3>();
    const Eigen::Vector3d positionByAxis = position.cross(axis),
                          rotationByAxis = rotation.cross(axis);
    for (int j = i; j < N; ++j) {
      const Eigen::Vector3d otherVelocity = at.posture.jacobian.col(j).template head<3>();
      const Eigen::Vector3d otherAxis = at.posture.jacobian.col(j).template tail<3>();
      curvature(i, j) = curvature(j, i) =
          kPositionWeight * (velocity - positionByAxis).dot(otherVelocity) +
          (turned.across * axis + turned.along * rotation.dot(axis) * rotation -
           0.5 * rotationByAxis)
              .dot(otherAxis);
    }
  }
  return curvature;
}

// Returns how steeply the cost falls along the joints that their limits leave free.
template <int N>
double slope(const Chain<N>& chain, const Standpoint<N>& at,
             const typename Chain<N>::Joints& descent) {
  double square = 0;
  for (int i = 0; i < N; ++i) {
    if (!leadsOut(chain, at.q, descent, i)) square += descent[i] * descent[i];
  }
  return std::sqrt(square);
}

// Returns Newton's step, damped until its curvature is convex. The damping goes with the slope, so
// that it vanishes where the search ends; along a self-motion the curvature is concave by no more
// than that.
template <int N>
typename Chain<N>::Joints stepFrom(const Chain<N>& chain, const Standpoint<N>& at, double caution) {
  constexpr int kAttempts = 5;
  constexpr double kMoreDamping = 6;
  const typename Chain<N>::Joints descent =
      at.posture.jacobian.transpose() * poseWeights().cwiseProduct(at.error);
  const Eigen::Matrix<double, N, N> curvature = curvatureOf(at);
  double damping = caution * slope(chain, at, descent) + kMinimumDamping;
  for (int i = 0; i < kAttempts; ++i) {
    Eigen::Matrix<double, N, N> damped = curvature;
    damped.diagonal().array() += damping;
    if (const auto step = stepWithinLimits(chain, at.q, damped, descent)) return *step;
    damping *= kMoreDamping;
  }
  return descent / damping;
}

template <int N>
InverseSolution<N> solutionAt(const Standpoint<N>& at, int iterations) {
  InverseSolution<N> solution;
  solution.q = at.q;
  solution.position_error = at.error.template head<3>().norm();
  solution.orientation_error = at.error.template tail<3>().norm();
  solution.iterations = iterations;
  solution.found = at.isAtGoal();
  return solution;
}

}  // namespace

template <int N>
InverseSolution<N> nearestWithinLimits(const Chain<N>& chain, const Eigen::Isometry3d& goal,
                                       const typename Chain<N>::Joints& begin) {
  constexpr double kLeastCaution = 0.25, kMoreCaution = 10, kLessCaution = 0.25;
  Standpoint<N> at(chain, goal, chain.clamp(begin));
  double caution = 1;
  int steps = 0;
  bool stands = at.isAtGoal() || !at.error.allFinite();
  for (; !stands && steps < kMostNearestSteps; ++steps) {
    const Standpoint<N> next(chain, goal, chain.clamp(at.q + stepFrom(chain, at, caution)));
    const double moved = (next.q - at.q).cwiseAbs().maxCoeff();
    if (next.cost < at.cost) {
      at = next;
      caution = std::max(kLeastCaution, kLessCaution * caution);
    } else {
      caution *= kMoreCaution;
    }
    stands = moved <= kLastStep || at.isAtGoal();
  }
  return solutionAt(at, steps);
}

template InverseSolution<6> nearestWithinLimits(const Chain<6>&, const Eigen::Isometry3d&,
                                                const Chain<6>::Joints&);
template InverseSolution<7> nearestWithinLimits(const Chain<7>&, const Eigen::Isometry3d&,
                                                const Chain<7>::Joints&);

}  // namespace robots::kinematics
