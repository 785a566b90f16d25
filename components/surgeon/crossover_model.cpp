#include "surgeon/crossover_model.h"

#include <cmath>
#include <numbers>

#include "parameters/parameter_check.h"
#include "timing/seconds.h"

namespace robots {
namespace {

constexpr double kRemnantBandwidth = 20;  // rad/s

std::size_t cyclesOf(const CrossoverParameters& parameters, suture::Duration period) {
  ParameterCheck("the crossover model")
      .isPositive("frequency in rad/s", parameters.frequency)
      .isNotNegative("delay in s", inSeconds(parameters.delay))
      .isNotNegative("remnant", parameters.remnant)
      .isPositive("period in s", inSeconds(period));
  // There is some room to spare, because after a late cycle others may follow sooner than a period.
  return static_cast<std::size_t>(parameters.delay / period * 5 / 4) + 8;
}

}  // namespace

CrossoverModel::CrossoverModel(const CrossoverParameters& parameters, suture::Duration period)
    : frequency_(parameters.frequency),
      delay_(parameters.delay),
      staying_(std::exp(-kRemnantBandwidth * inSeconds(period))),
      // Low-pass noise of the variance s^2 has the density 2 s^2 / bandwidth at low frequencies,
      // which must be pi * remnant.
      coming_(std::sqrt((1 - staying_ * staying_) * std::numbers::pi * parameters.remnant *
                        kRemnantBandwidth / 2)),
      random_(parameters.seed),
      seen_(cyclesOf(parameters, period)) {}

Eigen::Vector3d CrossoverModel::rate(suture::Time now, const Eigen::Vector3d& error) {
  seen_.add(now, error + error.cwiseProduct(noise()));
  return frequency_ * seen_.at(now - delay_).value_or(Eigen::Vector3d::Zero());
}

Eigen::Vector3d CrossoverModel::noise() {
  for (int i = 0; i < 3; ++i) noise_[i] = staying_ * noise_[i] + coming_ * normal_(random_);
  return noise_;
}

}  // namespace robots
