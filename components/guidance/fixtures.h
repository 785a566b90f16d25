#pragma once
// These are the virtual fixtures of placing a knot with two arms.

#include <Eigen/Core>

#include <limits>

#include "guidance/joint_room.h"
#include "guidance/quadratic_program.h"

namespace robots {

/// All are in the frame of the scene.
struct FixtureModel {
  Eigen::Vector3d target = Eigen::Vector3d::Zero();  ///< m: where the knot shall be
  Eigen::Vector3d approach{0, 0, -1};  ///< unit: the direction in which it comes there
  double radius = 0.0003;              ///< m: how wide the corridor is at the target
  double slope = 0.3;                  ///< how much the corridor widens for each metre before it
  double speed = 0.1;                  ///< m/s: of each tip along each axis
  double slowing = 4;                  ///< 1/s: speed towards the target, for each metre to go
  double separation = 0.01;            ///< m: how near the tips may come to each other
  double tissue = -1;                  ///< m: z of the tissue's surface, below which no tip may be
  /// The knot holds on the strand up to this ratio of the tensions beside it.
  double holding = std::numeric_limits<double>::infinity();
};

/// Holds one vector for each of the two tips, in m.
struct TipPair {
  Eigen::Vector3d left, right;

  Eigen::Vector3d mean() const { return (left + right) / 2; }
};

/// Holds the room that the joints of each arm leave its tip.
struct RoomPair {
  JointRoom left, right;
};

/// Belongs to one thread; never allocates. Solves constrained least squares in the manner of Funda,
/// Taylor, Li and Kapoor: it finds the step that is nearest to the one that the operator wishes and
/// that no fixture forbids. The knot is taken to move with the mean of the tips. The formulation is
/// our own; the fixtures are
///  - a corridor about the line of approach, narrower towards the target: eight planes for its
///    cone,
///  - the target, which the knot approaches ever slower and does not pass,
///  - the tissue, the distance between the tips, and a speed,
///  - the wish: no tip goes farther along an axis than its operator wishes to go, nor against that,
///  - the joints' limits and speeds, as far as the arms say them,
///  - the sliding cone: were the strand drawn too steep at one side of the knot and too flat at the
///    other, it would run through the knot, which would not move with the tips any more. What the
///    knot resists with is taken to act along the line of approach, so the tensions are as the
///    sines of the angles there, and the capstan's law bounds their ratio.
/// A fixture only forbids: standing still is always permitted, and no tip goes against its
/// operator's wish or beyond it.
class KnotFixtures {
 public:
  /// `approach` may have any length but zero.
  explicit KnotFixtures(const FixtureModel& model);

  /// Sets the z of the tissue's surface from now on, in m.
  void setTissue(double z) { model_.tissue = z; }

  /// Returns the steps in m that the tips may make in `seconds`, nearest to those that are
  /// `desired`; zero if the solver finds none. `knot` is where the knot is with the tips there, and
  /// `rooms` are those of this step. All are in the frame of the scene.
  TipPair constrain(const TipPair& tips, const Eigen::Vector3d& knot, const TipPair& desired,
                    double seconds, const RoomPair& rooms = {});

  /// Returns the distance in m along the line of approach; it is below zero behind the target.
  double distanceToTarget(const Eigen::Vector3d& knot) const;
  /// Returns the distance in m from the line of approach.
  double lateralError(const Eigen::Vector3d& knot) const;

 private:
  static constexpr int kPlanes = 8;
  static constexpr int kUnknowns = 6;
  static constexpr int kRows = 2 * kUnknowns + 2 + 2 + 1 + kPlanes + 1 + 4 * kTipJoints + 2;
  using Program = QuadraticProgram<kUnknowns, kRows>;
  struct Constraints;

  Eigen::Vector3d outward(int plane) const;
  void forbidHaste(const TipPair& desired, double seconds, Constraints& constraints) const;
  void forbidContact(const TipPair& tips, Constraints& constraints) const;
  void forbidLeavingCorridor(const Eigen::Vector3d& knot, double seconds,
                             Constraints& constraints) const;
  void forbidSliding(const TipPair& tips, const Eigen::Vector3d& knot,
                     Constraints& constraints) const;

  FixtureModel model_;
  Eigen::Vector3d across_[2];  // with `approach` they make a right-handed frame
  Program program_;
};

}  // namespace robots
