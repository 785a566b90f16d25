#include <suture/rt/spsc_ring.h>

#include <bit>
#include <cstring>

namespace suture::rt {

// A record that does not fit before the end starts at the beginning, so up to one record's length
// is lost there: twice the bytes asked for always suffice.
SpscRing::SpscRing(std::size_t bytes)
    : mask_(std::bit_ceil(2 * bytes + 64) - 1), data_(new std::byte[mask_ + 1]) {
  std::memset(data_.get(), 0, mask_ + 1);  // touches every page now, not in a control loop
}

std::byte* SpscRing::claim(std::size_t size) {
  const std::uint64_t tail = tail_.load(std::memory_order_relaxed);
  const std::size_t needed = recordSize(size);
  const std::size_t untilEnd = mask_ + 1 - (tail & mask_);
  const std::size_t skipped = needed <= untilEnd ? 0 : untilEnd;
  const std::uint64_t newTail = tail + skipped + needed;
  if (newTail - knownHead_ > mask_ + 1) {
    knownHead_ = head_.load(std::memory_order_acquire);
    if (newTail - knownHead_ > mask_ + 1) return nullptr;
  }
  if (skipped > 0) headerAt(tail) = kSkip;
  headerAt(tail + skipped) = size;
  claimedTail_ = newTail;
  return data_.get() + ((tail + skipped) & mask_) + sizeof(std::uint64_t);
}

const std::byte* SpscRing::front() {
  std::uint64_t head = head_.load(std::memory_order_relaxed);
  if (head == knownTail_) {
    knownTail_ = tail_.load(std::memory_order_acquire);
    if (head == knownTail_) return nullptr;
  }
  if (headerAt(head) == kSkip) {
    head += mask_ + 1 - (head & mask_);
    head_.store(head, std::memory_order_release);
  }
  return data_.get() + (head & mask_) + sizeof(std::uint64_t);
}

std::size_t SpscRing::frontSize() const { return headerAt(head_.load(std::memory_order_relaxed)); }

void SpscRing::pop() {
  const std::uint64_t head = head_.load(std::memory_order_relaxed);
  head_.store(head + recordSize(headerAt(head)), std::memory_order_release);
}

}  // namespace suture::rt
