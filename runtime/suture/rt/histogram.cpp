#include <suture/rt/histogram.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace suture::rt {

unsigned Histogram::bucketOf(std::uint64_t nanoseconds) {
  if (nanoseconds < (1u << kSubBits)) return static_cast<unsigned>(nanoseconds);
  const auto exponent = static_cast<unsigned>(std::bit_width(nanoseconds)) - 1 - kSubBits;
  const auto mantissa = static_cast<unsigned>(nanoseconds >> exponent);  // 16..31
  return std::min((exponent << kSubBits) + mantissa, kBuckets - 1);
}

std::uint64_t Histogram::upperEdge(unsigned bucket) {
  if (bucket < (1u << kSubBits)) return bucket;
  const unsigned exponent = (bucket >> kSubBits) - 1;
  const std::uint64_t mantissa = (bucket & ((1u << kSubBits) - 1)) + (1u << kSubBits);
  return ((mantissa + 1) << exponent) - 1;
}

void Histogram::record(Duration duration) {
  const std::int64_t nanoseconds = std::max<std::int64_t>(duration.count(), 0);
  auto& bucket = buckets_[bucketOf(static_cast<std::uint64_t>(nanoseconds))];
  // Single writer: plain load and store suffice.
  bucket.store(bucket.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  count_.store(count_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  if (nanoseconds > max_.load(std::memory_order_relaxed)) {
    max_.store(nanoseconds, std::memory_order_relaxed);
  }
}

void Histogram::clear() {
  for (auto& bucket : buckets_) bucket.store(0, std::memory_order_relaxed);
  count_.store(0, std::memory_order_relaxed);
  max_.store(0, std::memory_order_relaxed);
}

Duration Histogram::quantile(double quantile) const {
  const auto rank = static_cast<std::uint64_t>(std::ceil(quantile * static_cast<double>(count())));
  std::uint64_t seen = 0;
  for (unsigned i = 0; i < kBuckets && rank > 0; ++i) {
    seen += buckets_[i].load(std::memory_order_relaxed);
    if (seen >= rank) return std::min(Duration(static_cast<std::int64_t>(upperEdge(i))), max());
  }
  return Duration{0};
}

double Histogram::shareUpTo(Duration limit) const {
  if (count() == 0 || limit < Duration{0}) return 0;
  std::uint64_t seen = 0;
  for (unsigned i = 0; i <= bucketOf(static_cast<std::uint64_t>(limit.count())); ++i) {
    seen += buckets_[i].load(std::memory_order_relaxed);
  }
  return static_cast<double>(seen) / static_cast<double>(count());
}

}  // namespace suture::rt
