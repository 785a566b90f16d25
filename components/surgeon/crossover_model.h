#pragma once
// How an operator acts on an error that is seen.

#include <suture/base/time.h>

#include <Eigen/Core>
#include <chrono>
#include <cstdint>
#include <random>

#include "guidance/motion_history.h"

namespace robots {

struct CrossoverParameters {
  double frequency = 3;  ///< rad/s: of crossover
  /// From seeing to moving, nerves and muscles included.
  suture::Duration delay = std::chrono::milliseconds(200);
  /// What an operator adds to what is seen, as power of noise in each rad/s by the power of the
  /// error. 0.01, -20 dB, is the figure of Levison, Baron and Kleinman 1969.
  double remnant = 0.01;
  std::uint32_t seed = 1;
};

/// McRuer's crossover model: whatever operators control, they make of themselves and of it
///
///   Y_p Y_c = w_c exp(-j w tau) / (j w)
///
/// around the frequency of crossover w_c (McRuer and Jex, "A review of quasi-linear pilot models",
/// 1967). So what they control moves at w_c times the error that they saw tau ago. The loop is
/// stable as long as what else delays it takes less than pi / (2 w_c) - tau.
///
/// The remnant is noise on what is seen, in proportion to the error (Levison, Baron and Kleinman,
/// "A model for human controller remnant", 1969). Theirs is white; here it fades above 20 rad/s,
/// which is our own choice, for a hand has no infinite speed.
///
/// Confined to one thread; only the constructor allocates. Equal seeds, times and errors give equal
/// rates.
class CrossoverModel {
 public:
  /// A cycle takes `period`. Throws std::invalid_argument unless frequency and period are positive,
  /// and delay and remnant are not negative.
  CrossoverModel(const CrossoverParameters& parameters, suture::Duration period);

  /// Each cycle, by ascending `now`: the error is seen to be so much, m. Answers with how fast the
  /// operator reduces it, m/s: zero until the first error that was seen has passed the delay.
  Eigen::Vector3d rate(suture::Time now, const Eigen::Vector3d& error);
  /// Forgets what was seen.
  void forget() { seen_.clear(); }

 private:
  Eigen::Vector3d noise();

  double frequency_;
  suture::Duration delay_;
  // In each cycle this share of the noise stays, and so much comes to it, as a standard deviation.
  double staying_, coming_;
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
  Eigen::Vector3d noise_ = Eigen::Vector3d::Zero();  // by the error
  MotionHistory seen_;                               // errors
};

}  // namespace robots
