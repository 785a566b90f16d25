#pragma once
// This says how an operator acts on an error that is seen.

#include <suture/base/time.h>

#include <Eigen/Core>
#include <chrono>
#include <cstdint>
#include <random>

#include "guidance/motion_history.h"

namespace robots {

struct CrossoverParameters {
  double frequency = 3;  ///< rad/s: of crossover
  /// This time passes from seeing to moving, including nerves and muscles.
  suture::Duration delay = std::chrono::milliseconds(200);
  /// An operator adds this noise to what is seen: its power in each rad/s divided by the power of
  /// the error. 0.01, or -20 dB, is the number of Levison, Baron and Kleinman 1969.
  double remnant = 0.01;
  std::uint32_t seed = 1;
};

/// One thread; only the constructor allocates. Equal seeds, times and errors give equal rates.
///
/// This is McRuer's crossover model: whatever operators control, the operator and the controlled
/// system together behave like
///
///   Y_p Y_c = w_c exp(-j w tau) / (j w)
///
/// around the frequency of crossover w_c (McRuer and Jex, "A review of quasi-linear pilot models",
/// 1967). So what they control moves at w_c times the error that they saw tau ago. The loop is
/// stable as long as other delays in it are less than pi / (2 w_c) - tau.
///
/// The remnant is noise on what is seen, in proportion to the error (Levison, Baron and Kleinman,
/// "A model for human controller remnant", 1969). Theirs is white; here it fades above 20 rad/s,
/// which is our own choice, because a hand has no infinite speed.
class CrossoverModel {
 public:
  /// A cycle takes `period`. Throws std::invalid_argument unless frequency and period are positive,
  /// and delay and remnant are not negative.
  CrossoverModel(const CrossoverParameters& parameters, suture::Duration period);

  /// Call this in each cycle, by ascending `now`, with the error that is seen, in m. Returns how
  /// fast the operator reduces it, in m/s: zero until the first error that was seen has passed the
  /// delay.
  Eigen::Vector3d rate(suture::Time now, const Eigen::Vector3d& error);
  /// Forgets what was seen.
  void forget() { seen_.clear(); }

 private:
  Eigen::Vector3d noise();

  double frequency_;
  suture::Duration delay_;
  // In each cycle staying_ is the share of the noise that stays, and coming_ is what is added to
  // it, as a standard deviation.
  double staying_, coming_;
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
  Eigen::Vector3d noise_ = Eigen::Vector3d::Zero();  // relative to the error
  MotionHistory seen_;                               // errors
};

}  // namespace robots
