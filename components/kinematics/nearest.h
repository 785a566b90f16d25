#pragma once
// The joints within their limits that come nearest to a goal, in a bounded time.

#include "kinematics/inverse.h"

namespace robots::kinematics {

/// After so many iterations the search has not come to its end.
inline constexpr int kMostNearestSteps = 8;

/// Searches downhill from `begin` (cut to the limits) in at most eight Newton steps on the
/// weighted squared pose error. Unlike the steps of `inverse` they know the error's own curvature,
/// so they still converge where an error remains, as it does beyond a limit; where that curvature
/// is not convex they are damped. A joint that is pushed against its limit is held there for that
/// step. `limited` is left to the caller. From a `begin` that is at the goal it takes no step, and
/// from a goal that is not finite neither. Never allocates.
template <int N>
InverseSolution<N> nearestWithinLimits(const Chain<N>& chain, const Eigen::Isometry3d& goal,
                                       const typename Chain<N>::Joints& begin);

extern template InverseSolution<6> nearestWithinLimits(const Chain<6>&, const Eigen::Isometry3d&,
                                                       const Chain<6>::Joints&);
extern template InverseSolution<7> nearestWithinLimits(const Chain<7>&, const Eigen::Isometry3d&,
                                                       const Chain<7>::Joints&);

}  // namespace robots::kinematics
