#pragma once
// This finds set-points that moved farther at once than a person's hand does.

#include <Eigen/Geometry>
#include <deque>
#include <string>
#include <vector>

namespace robots {

/// Says by how much a set-point moved farther within 50 ms, or less, than a fast hand does, in m,
/// and by how much it turned farther, in rad.
struct Jumps {
  double largest = 0;
  double largest_turn = 0;
};

/// A JumpWatch is told of the set-points of one arm, one after the other. A jump may come in
/// pieces, so each is compared with the earlier ones of the last 50 ms.
class JumpWatch {
 public:
  /// `seconds` is for how long the arm may have moved since the set-point before.
  void add(const Eigen::Isometry3d& setpoint, double seconds);
  /// Compares what comes with nothing from before.
  void forget() { window_.clear(); }

  const Jumps& jumps() const { return jumps_; }

 private:
  struct Earlier {
    Eigen::Vector3d p;
    Eigen::Quaterniond q;
    double at;  // s on clock_
  };

  std::deque<Earlier> window_;
  double clock_ = 0;  // s of motion
  Jumps jumps_;
};

/// Returns each bound that is missed, in words: 3 mm and 3 degrees, which is how far an arm's data
/// may lag behind at the demo's speeds.
std::vector<std::string> violations(const Jumps& jumps);

}  // namespace robots
