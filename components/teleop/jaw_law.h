#pragma once
// This is the law by which a slave's jaw follows the gripper of its master.

#include <algorithm>
#include <cmath>

namespace robots {

struct JawSettings {
  double scale;       ///< radians of the jaw for each radian of the gripper
  double offset;      ///< rad, of the jaw with the gripper at 0
  double rate;        ///< rad/s, while it follows
  double ghost_rate;  ///< rad/s, until it has caught up
  double tolerance;   ///< rad: when it is this near it has caught up
};

/// No method allocates or throws. The law is jaw = scale x gripper + offset, at a limited rate. At
/// an entry gripper and jaw are apart. The jaw first goes slowly to where the gripper is, so that
/// nothing is dropped or crushed at once, and follows from there. This is the law of the da Vinci
/// Research Kit, which calls the slow jaw a ghost (sawIntuitiveResearchKit, mtsTeleOperationPSM).
class JawLaw {
 public:
  /// Begins from `jaw`, which is the set-point of the jaw, in rad.
  JawLaw(const JawSettings& settings, double jaw) : settings_(settings), jaw_(jaw) {}

  bool isGhost() const { return ghost_; }

  /// Returns where the jaw shall be (rad) `seconds` after the last call, with the gripper at
  /// `gripper` rad.
  double follow(double gripper, double seconds) {
    const double wanted = settings_.scale * gripper + settings_.offset;
    const double most = (ghost_ ? settings_.ghost_rate : settings_.rate) * seconds;
    jaw_ += std::clamp(wanted - jaw_, -most, most);
    ghost_ = ghost_ && std::abs(wanted - jaw_) > settings_.tolerance;
    return jaw_;
  }

 private:
  JawSettings settings_;
  double jaw_;
  bool ghost_ = true;
};

}  // namespace robots
