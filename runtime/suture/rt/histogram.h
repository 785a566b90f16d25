#pragma once
// How a duration is distributed, in fixed memory.

#include <suture/base/time.h>

#include <array>
#include <atomic>
#include <cstdint>

namespace suture::rt {

/// Durations from 1 ns to about 18 s in buckets of at most 6 % width. One thread records; any
/// thread may read while it does. No allocation, no locks.
class Histogram {
 public:
  /// `mostInBucket`: a bucket of 32 bits is full some day. Then all are halved, which leaves the
  /// shares as they are.
  explicit Histogram(std::uint32_t mostInBucket = ~std::uint32_t{0})
      : mostInBucket_(mostInBucket) {}

  void record(Duration duration);
  /// The recording thread, where no other reads: forgets everything.
  void clear();

  std::uint64_t count() const { return count_.load(std::memory_order_relaxed); }
  Duration max() const { return Duration(max_.load(std::memory_order_relaxed)); }
  /// Upper edge of the bucket below which the share `quantile` (0..1) lies; 0 if nothing was
  /// recorded.
  Duration quantile(double quantile) const;
  /// The share (0..1) of what was recorded that is at most `limit`, counting the bucket of `limit`
  /// in; 0 if nothing was recorded.
  double shareUpTo(Duration limit) const;

 private:
  static constexpr unsigned kSubBits = 4;  // 16 buckets for each doubling
  static constexpr unsigned kBuckets = 32 << kSubBits;

  static unsigned bucketOf(std::uint64_t nanoseconds);
  void halve();
  /// How many the first `buckets` have.
  std::uint64_t inFirst(unsigned buckets) const;
  static std::uint64_t upperEdge(unsigned bucket);

  const std::uint32_t mostInBucket_;
  std::array<std::atomic<std::uint32_t>, kBuckets> buckets_{};
  std::atomic<std::uint64_t> count_{0};
  std::atomic<std::int64_t> max_{0};
};

}  // namespace suture::rt
