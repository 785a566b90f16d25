#pragma once
// These are serial chains in Denavit-Hartenberg form, with forward kinematics and geometric
// Jacobian.

#include <Eigen/Geometry>
#include <array>
#include <cstddef>

#include "kinematics/spatial_vector.h"

namespace robots::kinematics {

/// Says where a link's frame sits. Standard: T = Rz(theta) Tz(d) Tx(a) Rx(alpha), joint i moves
/// about z of frame i-1. Modified (Craig, "Introduction to Robotics", 1989): T = Rx(alpha) Tx(a)
/// Rz(theta) Tz(d), joint i moves about z of frame i.
enum class Convention { Standard, Modified };

enum class JointKind { Revolute, Prismatic };

/// A Link is one row of a DH table. The joint value is added to `offset`: theta of a revolute joint
/// (rad), d of a prismatic one (m). Limits are of the joint value, so without the offset.
struct Link {
  double alpha;   ///< rad
  double a;       ///< m
  double d;       ///< m; 0 for a prismatic joint, whose constant part is `offset`
  double offset;  ///< rad or m
  double lower;   ///< rad or m
  double upper;   ///< rad or m
  JointKind kind = JointKind::Revolute;
};

/// Any thread, because it is immutable; no method allocates. A Chain has N joints from base to tip.
/// Joint vectors have N entries, rad for revolute and m for prismatic joints.
template <int N>
class Chain {
 public:
  static constexpr int kJoints = N;
  using Joints = Eigen::Matrix<double, N, 1>;
  using Jacobian = Eigen::Matrix<double, 6, N>;

  /// `tip` is the tool tip in the frame of the last link.
  Chain(Convention convention, const std::array<Link, std::size_t{N}>& links,
        const Eigen::Isometry3d& tip = Eigen::Isometry3d::Identity());

  /// Returns the tool tip in the base frame, with its translation in m.
  Eigen::Isometry3d forward(const Joints& q) const;

  /// Returns the frame behind the first `joints` joints, 0 to N; N is the tool tip.
  Eigen::Isometry3d link(const Joints& q, int joints) const;
  JointKind kind(int joint) const { return segments_[static_cast<std::size_t>(joint)].kind; }

  /// Returns the frame behind joint `joint` at `q`, in the frame before it.
  Eigen::Isometry3d relative(int joint, double q) const;
  /// Returns how the frame behind joint `joint` moves per unit of its velocity, in that frame's own
  /// axes and at its origin. It does not depend on `q`.
  SpatialVector screw(int joint) const;

  /// Returns the geometric Jacobian (6 x N) of the tool tip in the base frame: rows 0..2 are the
  /// linear velocity of the tip point (m/s), rows 3..5 the angular velocity (rad/s), per unit of
  /// joint velocity.
  Jacobian jacobian(const Joints& q) const { return posture(q).jacobian; }

  struct Posture {
    Eigen::Isometry3d tip;
    Jacobian jacobian;
  };
  /// Returns what forward() and jacobian() return, in one pass over the joints.
  Posture posture(const Joints& q) const;

  const Joints& lower() const { return lower_; }
  const Joints& upper() const { return upper_; }
  Joints clamp(const Joints& q) const { return q.cwiseMax(lower_).cwiseMin(upper_); }
  bool within(const Joints& q) const {
    return (q.array() >= lower_.array()).all() && (q.array() <= upper_.array()).all();
  }

 private:
  // A link is before * motion(q) * after in either convention; the joint moves about or along z of
  // the frame to which `before` leads.
  struct Segment {
    Eigen::Isometry3d before;
    Eigen::Isometry3d after;
    Eigen::Isometry3d toNext;  // after * before of the next link, for one product less a joint
    JointKind kind;
  };
  // Returns the frame in which joint `i + 1` moves, or behind the last one the tool tip.
  Eigen::Isometry3d beyond(const Eigen::Isometry3d& joint, const Joints& q, int i) const;

  std::array<Segment, std::size_t{N}> segments_;
  Joints lower_;
  Joints upper_;
};

extern template class Chain<6>;
extern template class Chain<7>;

}  // namespace robots::kinematics
