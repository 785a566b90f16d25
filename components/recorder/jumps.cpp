#include "recorder/jumps.h"

#include <algorithm>
#include <cstddef>
#include <numbers>

#include "recorder/judging.h"

namespace robots {
namespace {

constexpr double kDegree = std::numbers::pi / 180;  // rad
constexpr double kJumpTime = 0.05;                  // s: what is slower is no jump
constexpr double kLargestJump = 0.003;              // m
constexpr double kLargestTurn = 3 * kDegree;        // rad
constexpr double kFastest = 0.25;                   // m/s, of a fast hand
constexpr double kFastestTurn = 3;                  // rad/s, of a fast hand

}  // namespace

void JumpWatch::add(const Eigen::Isometry3d& setpoint, double seconds) {
  clock_ += seconds;
  while (window_.size() > 1 && clock_ - window_[1].at >= kJumpTime) window_.pop_front();
  const Earlier now{setpoint.translation(), Eigen::Quaterniond(setpoint.linear()), clock_};
  for (const Earlier& earlier : window_) {
    const double time = clock_ - earlier.at;
    jumps_.largest = std::max(jumps_.largest, (now.p - earlier.p).norm() - kFastest * time);
    jumps_.largest_turn =
        std::max(jumps_.largest_turn, now.q.angularDistance(earlier.q) - kFastestTurn * time);
  }
  window_.push_back(now);
}

std::vector<std::string> violations(const Jumps& jumps) {
  std::vector<std::string> found;
  if (jumps.largest > kLargestJump) {
    found.push_back(sentence("its set-point jumped by %.1f mm, at most %.1f mm allowed",
                             1e3 * jumps.largest, 1e3 * kLargestJump));
  }
  if (jumps.largest_turn > kLargestTurn) {
    found.push_back(sentence("its set-point turned by %.1f deg at once, at most %.1f deg allowed",
                             jumps.largest_turn / kDegree, kLargestTurn / kDegree));
  }
  return found;
}

}  // namespace robots
