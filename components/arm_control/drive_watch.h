#pragma once
// This finds measurements of the drives which show that something is wrong with them.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "arm/arm_warning.h"
#include "arm_control/drive_reading.h"
#include "timing/seconds.h"

namespace robots {

/// Bounds what a joint that is in order does; units per second, and counts of its encoder, in rad
/// or m.
struct DriveBounds {
  double rate_limit = std::numeric_limits<double>::infinity();
  double effort_limit = std::numeric_limits<double>::infinity();  ///< N.m, or N
  double encoder_step = 0;
};

struct DriveWatchOptions {
  /// A position jumps if it lies farther from the one before than this many times what the joint
  /// can move in the time between both, by their stamps or by when the arm had them, whichever is
  /// longer, and one count. If this is infinite, nothing is a jump.
  double jump_factor = std::numeric_limits<double>::infinity();
  /// An effort may be above its limit for this long, in s.
  double overload_time = std::numeric_limits<double>::infinity();
};

struct DriveFault {
  ArmWarning reason;  ///< EncoderJump or OverCurrent
  int joint;          ///< the number in the chain; the one behind the last is the tool's
};

/// One thread; never allocates. Looks at the readings of the joints and of the tool behind them.
template <int N>
class DriveWatch {
 public:
  using Bounds = std::array<DriveBounds, std::size_t{N} + 1>;

  DriveWatch(const Bounds& bounds, const DriveWatchOptions& options)
      : bounds_(bounds), options_(options) {}

  /// Takes one reading at time `now`, which may be the same as the last. Returns the fault that it
  /// shows, if it does.
  std::optional<DriveFault> look(const DriveReading<N>& reading, suture::Time now) {
    if (reading.stamp == last_.stamp) return std::nullopt;
    const bool isFirst = last_.stamp == suture::Time{};
    const double dt = isFirst ? 0 : std::max(secondsBetween(last_.stamp, reading.stamp), 0.0);
    // The stamps of drives in another process lie closer together than their cycles did where the
    // estimate of its clock steps back, but the time here passes in any case.
    const double moved = std::max(dt, secondsBetween(lastLook_, now));
    std::optional<DriveFault> fault;
    for (int i = N; i >= 0; --i) {
      if (overloads(i, reading, dt)) fault = {ArmWarning::OverCurrent, i};
      if (!isFirst && jumps(i, reading, moved)) fault = {ArmWarning::EncoderJump, i};
    }
    last_ = reading;
    lastLook_ = now;
    return fault;
  }
  /// Restarts the time for which each effort has been above its limit.
  void resetOverloads() { overloaded_.fill(0); }

 private:
  // A motor may give its limit for any length of time, and couplings round the numbers.
  static constexpr double kRounding = 1 + 1e-9;

  static double positionOf(int joint, const DriveReading<N>& reading) {
    return joint < N ? reading.position[joint] : reading.tool.position;
  }
  static double effortOf(int joint, const DriveReading<N>& reading) {
    return joint < N ? reading.effort[joint] : reading.tool.effort;
  }
  bool jumps(int joint, const DriveReading<N>& reading, double dt) const {
    const DriveBounds& bounds = bounds_[static_cast<std::size_t>(joint)];
    const double most = options_.jump_factor * (bounds.rate_limit * dt + bounds.encoder_step);
    return std::abs(positionOf(joint, reading) - positionOf(joint, last_)) > most;
  }
  bool overloads(int joint, const DriveReading<N>& reading, double dt) {
    const auto i = static_cast<std::size_t>(joint);
    const double most = kRounding * bounds_[i].effort_limit;
    const bool isAbove = std::abs(effortOf(joint, reading)) > most;
    const bool wasAbove = std::abs(effortOf(joint, last_)) > most;  // since when is unknown if not
    overloaded_[i] = isAbove && wasAbove ? overloaded_[i] + dt : 0;
    return overloaded_[i] > options_.overload_time;
  }

  const Bounds bounds_;
  const DriveWatchOptions options_;
  DriveReading<N> last_;
  suture::Time lastLook_;
  std::array<double, std::size_t{N} + 1> overloaded_{};  // s: for how long
};

}  // namespace robots
