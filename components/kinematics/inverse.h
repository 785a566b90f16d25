#pragma once
// This is inverse kinematics by damped least squares.

#include "kinematics/chain.h"

namespace robots::kinematics {

struct InverseOptions {
  int max_iterations = 60;
  double position_tolerance = 1e-9;     ///< m
  double orientation_tolerance = 1e-9;  ///< rad
};

/// An InverseSolution is the answer of `inverse`. It is within the joint limits even if the goal
/// was not found: then it is the nearest that was reached, where 0.1 m of position weigh as much as
/// 1 rad of orientation.
template <int N>
struct InverseSolution {
  typename Chain<N>::Joints q;
  double position_error = 0;     ///< m
  double orientation_error = 0;  ///< rad
  int iterations = 0;
  bool found = false;  ///< both errors are within tolerance
  /// This is true if only the joint limits keep the arm from the goal, and `q` is the nearest that
  /// is within them. If the goal is neither found nor limited, no joint vector that the search
  /// finds reaches it.
  bool limited = false;
};

/// Returns a joint vector whose tip pose is `goal` (base frame), searched from `start`; joints that
/// need not move stay near there. It uses Levenberg-Marquardt with the damping proportional to the
/// squared error (Sugihara, "Solvability-unconcerned inverse kinematics by the Levenberg-Marquardt
/// method", IEEE Transactions on Robotics 27(5), 2011), so it diverges neither at a singularity nor
/// out of reach. A joint that is pushed against its limit is held there for that iteration. A goal
/// that is not finite is not found. Never allocates; time is bounded by twice max_iterations.
template <int N>
InverseSolution<N> inverse(const Chain<N>& chain, const Eigen::Isometry3d& goal,
                           const typename Chain<N>::Joints& start,
                           const InverseOptions& options = {});

/// Says which postures of the arm may be the answer.
enum class Postures {
  All,  ///< any that reaches the goal: for a move that is planned
  /// These postures lie within 1 rad and 0.1 m of the start with every joint. A stream uses them,
  /// and slides along a limit if only another posture, or another turn of a joint, reaches its
  /// goal.
  Near,
};

/// An arm solves its inverse kinematics by such a function: a closed form, or the search above.
template <int N>
using InverseFunction = InverseSolution<N> (*)(const Chain<N>& chain, const Eigen::Isometry3d& goal,
                                               const typename Chain<N>::Joints& start,
                                               Postures postures);

/// Searches as `inverse` does. It goes downhill from its start, whatever `postures` says.
template <int N>
InverseSolution<N> searched(const Chain<N>& chain, const Eigen::Isometry3d& goal,
                            const typename Chain<N>::Joints& start, Postures /*postures*/) {
  return inverse(chain, goal, start);
}

extern template InverseSolution<6> inverse(const Chain<6>&, const Eigen::Isometry3d&,
                                           const Chain<6>::Joints&, const InverseOptions&);
extern template InverseSolution<7> inverse(const Chain<7>&, const Eigen::Isometry3d&,
                                           const Chain<7>::Joints&, const InverseOptions&);

}  // namespace robots::kinematics
