#pragma once
// The judges of recordings share this: how errors are summed up, and how a missed bound is
// reported.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

namespace robots {

struct ErrorSummary {
  double p50 = 0, p99 = 0, max = 0, mean = 0;
};

/// Returns all zeros if there are no errors.
inline ErrorSummary summarise(std::vector<double> errors) {
  if (errors.empty()) return {};
  const double count = static_cast<double>(errors.size());
  const double mean = std::accumulate(errors.begin(), errors.end(), 0.0) / count;
  std::sort(errors.begin(), errors.end());
  const auto at = [&](double share) {
    return errors[static_cast<std::size_t>(share * (count - 1))];
  };
  return {at(0.5), at(0.99), errors.back(), mean};
}

/// Counts errors in buckets of 1 % width. Its greatest and its mean are exact. A quantile is the
/// upper edge of its bucket, so that up to 1,000 it is never less than the true one.
class ErrorHistogram {
 public:
  /// `error` is not below zero.
  void add(double error) {
    ++buckets_[bucketOf(error)];
    ++count_;
    sum_ += error;
    max_ = std::max(max_, error);
  }

  std::size_t count() const { return count_; }

  /// Returns all zeros if there are no errors.
  ErrorSummary summary() const {
    if (count_ == 0) return {};
    return {quantile(0.5), quantile(0.99), max_, sum_ / static_cast<double>(count_)};
  }

 private:
  static constexpr double kLeast = 1e-9;  // what is less is in the first bucket
  static constexpr double kWidth = 1.01;  // each bucket ends so many times farther than it begins
  static constexpr std::size_t kBuckets = 2800;  // up to a thousand

  static std::size_t bucketOf(double error) {
    if (!(error > kLeast)) return 0;
    const double bucket = std::ceil(std::log(error / kLeast) / std::log(kWidth));
    return std::min(static_cast<std::size_t>(bucket), kBuckets - 1);
  }

  double quantile(double share) const {
    const auto wanted = static_cast<std::uint64_t>(share * static_cast<double>(count_ - 1));
    std::uint64_t passed = 0;
    for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
      passed += buckets_[bucket];
      if (passed <= wanted) continue;
      return std::min(max_, kLeast * std::pow(kWidth, static_cast<double>(bucket)));
    }
    return max_;
  }

  std::array<std::uint64_t, kBuckets> buckets_{};
  std::size_t count_ = 0;
  double sum_ = 0, max_ = 0;
};

/// Returns a sentence about a missed bound. `format` is that of printf, for two doubles: what was
/// found, and its bound.
inline std::string sentence(const char* format, double found, double bound) {
  char text[128];
  std::snprintf(text, sizeof text, format, found, bound);
  return text;
}

}  // namespace robots
