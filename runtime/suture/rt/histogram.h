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
  static std::uint64_t upperEdge(unsigned bucket);

  std::array<std::atomic<std::uint64_t>, kBuckets> buckets_{};
  std::atomic<std::uint64_t> count_{0};
  std::atomic<std::int64_t> max_{0};
};

}  // namespace suture::rt
