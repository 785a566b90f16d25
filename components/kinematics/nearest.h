#pragma once
// This finds the joints within their limits that come nearest to a goal, in a bounded time.

#include "kinematics/inverse.h"

namespace robots::kinematics {

/// If the search has made this many iterations, it has not come to its end.
inline constexpr int kMostNearestSteps = 8;

/// Searches downhill from `begin` (cut to the limits) in at most eight Newton steps on the weighted
/// squared pose error. Unlike the steps of `inverse` they use the error's own curvature, so they
/// still converge if an error remains, as it does beyond a limit; if that curvature is not convex
/// they are damped. A joint that is pushed against its limit is held there for that step. The
/// caller must set `limited`. It takes no step if `begin` is at the goal, or if the goal is not
/// finite. Never allocates.
template <int N>
InverseSolution<N> nearestWithinLimits(const Chain<N>& chain, const Eigen::Isometry3d& goal,
                                       const typename Chain<N>::Joints& begin);

extern template InverseSolution<6> nearestWithinLimits(const Chain<6>&, const Eigen::Isometry3d&,
                                                       const Chain<6>::Joints&);
extern template InverseSolution<7> nearestWithinLimits(const Chain<7>&, const Eigen::Isometry3d&,
                                                       const Chain<7>::Joints&);

}  // namespace robots::kinematics
