#pragma once
// This is a suture strand with a knot on it, between two instrument tips.

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace robots {

/// These numbers are our own: about those of a 3-0 braided suture, but with a mass that is a
/// hundred times larger, so that steps of a millisecond can follow it.
struct StrandModel {
  double length = 0.11;                  ///< m, both sides of the knot together; at least 0.02
  double mass = 0.006;                   ///< kg, of the strand
  double knot_mass = 0.002;              ///< kg
  double stiffness = 2000;               ///< N/m, of the strand as a whole
  double damping = 30;                   ///< 1/s: how fast a movement dies out
  double friction = 0.15;                ///< between two parts of the strand
  double wrap = 9.42;                    ///< rad: how far the strand winds about itself in the knot
  double slip = 0.05;                    ///< m/s for each N beyond the friction
  Eigen::Vector3d gravity{0, 0, -9.81};  ///< m/s^2
  double tissue = -1;  ///< m: z of the tissue's surface, below which no node may be
};

/// Belongs to one thread; no method allocates. A Strand is a chain of point masses with stiff
/// links, moved by extended position-based dynamics (Macklin et al., "XPBD", 2016). The links of a
/// chain make a tridiagonal system, which is solved at once, so that tensions are exact in each
/// step and need no iteration over the chain.
///
/// The knot winds the strand about itself, so it holds as a capstan does: the strand runs through
/// it only while the tension of one side exceeds that of the other by more than exp(friction *
/// wrap). Sides are those of the tips.
class Strand {
 public:
  static constexpr int kNodes = 61;
  static constexpr int kKnot = kNodes / 2;
  using Nodes = Eigen::Matrix<double, 3, kNodes>;

  /// Says where a strand can be held.
  enum class Place : std::uint8_t { Left, Knot, Right };

  /// The strand is straight between two points (m), with the knot in the middle; both ends are held
  /// there. The points must not coincide.
  Strand(const StrandModel& model, const Eigen::Vector3d& left, const Eigen::Vector3d& right);

  /// Holds the place at `point` (m) from the next step on, whatever pulls at it.
  void hold(Place place, const Eigen::Vector3d& point);
  /// Frees the place from the next step on, except for a force in N.
  void pull(Place place, const Eigen::Vector3d& force);
  /// Moves on by `seconds`, in steps of at most kStep.
  void advance(double seconds);
  static constexpr double kStep = 0.001;

  const Nodes& nodes() const { return nodes_; }
  Eigen::Vector3d knot() const { return nodes_.col(kKnot); }
  /// Return the tensions beside the knot, in N; below zero a link is pushed.
  double leftTension() const { return tension_[kKnot - 1]; }
  double rightTension() const { return tension_[kKnot]; }
  /// Returns how many m of strand are between the left tip and the knot; the rest is on the right.
  double leftLength() const { return leftLength_; }

 private:
  static constexpr int kLinks = kNodes - 1;
  static constexpr int nodeOf(Place place);

  void step(double h);
  void projectConstraints(const Nodes& before, double h);
  void slip(double h);
  double restLength(int link) const;

  StrandModel model_;
  double holdingRatio_;  // exp(mu * phi): the ratio of the tensions beyond which the strand runs
  Nodes nodes_, velocities_ = Nodes::Zero(), forces_ = Nodes::Zero();
  Eigen::Array<double, kNodes, 1> mass_;
  std::array<bool, kNodes> held_{};
  std::array<double, kLinks> tension_{};
  double leftLength_;
};

}  // namespace robots
