#pragma once
// This says how a duration is distributed, in fixed memory.

#include <suture/base/time.h>

#include <array>
#include <atomic>
#include <cstdint>

namespace suture::rt {

/// One thread records; any thread may read meanwhile. Counts durations from 1 ns to about 18 s in
/// buckets of at most 6 % width. Never allocates or locks.
class Histogram {
 public:
  /// `mostInBucket` is the most that a bucket may hold: one of 32 bits is full some day. All
  /// buckets are halved then, which leaves the shares as they are.
  explicit Histogram(std::uint32_t mostInBucket = ~std::uint32_t{0})
      : mostInBucket_(mostInBucket) {}

  void record(Duration duration);
  /// The recording thread, while no other reads. Forgets everything.
  void clear();

  std::uint64_t count() const { return count_.load(std::memory_order_relaxed); }
  Duration max() const { return Duration(max_.load(std::memory_order_relaxed)); }
  /// Returns the upper edge of the bucket below which the share `quantile` (0..1) lies; 0 if
  /// nothing was recorded.
  Duration quantile(double quantile) const;
  /// Returns the share (0..1) of what was recorded that is at most `limit`, including the whole
  /// bucket of `limit`; 0 if nothing was recorded.
  double shareUpTo(Duration limit) const;

 private:
  static constexpr unsigned kSubBits = 4;  // 16 buckets for each doubling
  static constexpr unsigned kBuckets = 32 << kSubBits;

  static unsigned bucketOf(std::uint64_t nanoseconds);
  void halve();
  /// Returns how many durations the first `buckets` buckets hold.
  std::uint64_t inFirst(unsigned buckets) const;
  static std::uint64_t upperEdge(unsigned bucket);

  const std::uint32_t mostInBucket_;
  std::array<std::atomic<std::uint32_t>, kBuckets> buckets_{};
  std::atomic<std::uint64_t> count_{0};
  std::atomic<std::int64_t> max_{0};
};

}  // namespace suture::rt
