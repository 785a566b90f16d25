#pragma once
// Models judge their parameters with this when they are made.

#include <Eigen/Core>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace robots {

/// Throws std::invalid_argument for a parameter that cannot be, and says which one, what was found
/// and what may be: "a hand: its mass is 0, and must be positive". An infinite one may be, unless
/// isFinite() is asked, but none that is not a number.
class ParameterCheck {
 public:
  /// `model` begins the sentence, as in "a hand", and outlives this object.
  explicit ParameterCheck(const char* model) : model_(model) {}

  const ParameterCheck& isPositive(const char* parameter, double value) const {
    return require(value > 0, parameter, value, "positive");
  }
  const ParameterCheck& isNotNegative(const char* parameter, double value) const {
    return require(value >= 0, parameter, value, "zero or more");
  }
  const ParameterCheck& isFinite(const char* parameter, double value) const {
    return require(std::isfinite(value), parameter, value, "finite");
  }
  /// These judge a parameter that has a value for each joint.
  template <int N>
  const ParameterCheck& arePositive(const char* parameter,
                                    const Eigen::Matrix<double, N, 1>& values) const {
    for (const double value : values) isPositive(parameter, value);
    return *this;
  }
  template <int N>
  const ParameterCheck& areNotNegative(const char* parameter,
                                       const Eigen::Matrix<double, N, 1>& values) const {
    for (const double value : values) isNotNegative(parameter, value);
    return *this;
  }

 private:
  const ParameterCheck& require(bool possible, const char* parameter, double value,
                                const char* what) const {
    if (possible) return *this;
    std::ostringstream text;
    text << model_ << ": its " << parameter << " is " << value << ", and must be " << what;
    throw std::invalid_argument(text.str());
  }

  const char* model_;
};

}  // namespace robots
