#pragma once
// This says how a hand shakes that is held still.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

namespace robots {

struct TremorModel {
  /// The distance from where the hand shall be has this root mean square, in m. Published values
  /// are 50 to 200 um (Wells et al., "Comparison of baseline tremor under various microsurgical
  /// conditions", 2013, PMC3989364).
  double amplitude = 1e-4;
  std::uint32_t seed = 1;
};

/// Immutable; no method allocates. A Tremor is physiological tremor: 8 to 12 Hz (the same source),
/// along each axis by itself. It is a sum of sines, whose frequencies and phases the seed chooses,
/// so it has no power outside of that band and equal seeds give equal tremor.
class Tremor {
 public:
  static constexpr double kLowest = 8, kHighest = 12;  // Hz

  explicit Tremor(const TremorModel& model);

  struct Motion {
    Eigen::Vector3d offset;        ///< m
    Eigen::Vector3d velocity;      ///< m/s
    Eigen::Vector3d acceleration;  ///< m/s^2
  };
  /// Returns how a hand that holds nothing moves, `t` seconds after it began.
  Motion at(double t) const;

 private:
  static constexpr std::size_t kSines = 8;  // how many make up the tremor of one axis
  struct Sine {
    double frequency;  // rad/s
    double phase;      // rad
  };

  double height_;  // m, of each sine
  std::array<std::array<Sine, kSines>, 3> axes_;
};

}  // namespace robots
