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
  // A plain load and store suffice, because only one thread writes.
  if (bucket.load(std::memory_order_relaxed) == mostInBucket_) halve();
  bucket.store(bucket.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  count_.store(count_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  if (nanoseconds > max_.load(std::memory_order_relaxed)) {
    max_.store(nanoseconds, std::memory_order_relaxed);
  }
}

void Histogram::halve() {
  for (auto& bucket : buckets_) {
    bucket.store(bucket.load(std::memory_order_relaxed) / 2, std::memory_order_relaxed);
  }
}

std::uint64_t Histogram::inFirst(unsigned buckets) const {
  std::uint64_t sum = 0;
  for (unsigned i = 0; i < buckets; ++i) sum += buckets_[i].load(std::memory_order_relaxed);
  return sum;
}

void Histogram::clear() {
  for (auto& bucket : buckets_) bucket.store(0, std::memory_order_relaxed);
  count_.store(0, std::memory_order_relaxed);
  max_.store(0, std::memory_order_relaxed);
}

Duration Histogram::quantile(double quantile) const {
  const auto all = static_cast<double>(inFirst(kBuckets));
  const auto rank = static_cast<std::uint64_t>(std::ceil(quantile * all));
  std::uint64_t seen = 0;
  for (unsigned i = 0; i < kBuckets && rank > 0; ++i) {
    seen += buckets_[i].load(std::memory_order_relaxed);
    if (seen >= rank) return std::min(Duration(static_cast<std::int64_t>(upperEdge(i))), max());
  }
  return Duration{0};
}

double Histogram::shareUpTo(Duration limit) const {
  const std::uint64_t all = inFirst(kBuckets);
  if (all == 0 || limit < Duration{0}) return 0;
  const unsigned last = bucketOf(static_cast<std::uint64_t>(limit.count()));
  return static_cast<double>(inFirst(last + 1)) / static_cast<double>(all);
}

}  // namespace suture::rt
