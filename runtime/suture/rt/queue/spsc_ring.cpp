#include <suture/rt/queue/spsc_ring.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace suture::rt {

// A record that does not fit before the end starts at the beginning, so that up to the length of
// one record is lost there.
SpscRing::SpscRing(std::size_t bytes, std::size_t largest, Arena& arena)
    : mask_(std::bit_ceil(bytes + recordSize(largest)) - 1),
      shared_(arena.make<Shared>()),
      data_(arena.take(mask_ + 1)) {
  if (arena.foreign()) copy_.resize(std::max<std::size_t>(largest, 1));
}

std::byte* SpscRing::claim(std::size_t size) {
  const std::size_t needed = recordSize(size);
  const std::size_t skipped = needed <= untilEnd(tail_) ? 0 : untilEnd(tail_);
  const std::uint64_t newTail = tail_ + skipped + needed;
  if (newTail - knownHead_ > mask_ + 1) {
    knownHead_ = shared_->head.load(std::memory_order_acquire);
    if (newTail - knownHead_ > mask_ + 1) return nullptr;
  }
  if (skipped > 0) headerAt(tail_) = kSkip;
  headerAt(tail_ + skipped) = size;
  claimedTail_ = newTail;
  return data_.get() + ((tail_ + skipped) & mask_) + sizeof(std::uint64_t);
}

const std::byte* SpscRing::oldest() {
  if (head_ == knownTail_) {
    knownTail_ = shared_->tail.load(std::memory_order_acquire);
    if (head_ == knownTail_) return nullptr;
  }
  if (!copy_.empty()) return oldestForeign();
  if (headerAt(head_) == kSkip) {
    head_ += untilEnd(head_);
    shared_->head.store(head_, std::memory_order_release);
  }
  return data_.get() + (head_ & mask_) + sizeof(std::uint64_t);
}

// Reads each number once, because it may change, and accepts it only if it lies within the ring.
const std::byte* SpscRing::oldestForeign() {
  const std::uint64_t published = knownTail_ - head_;
  std::uint64_t position = head_, size;
  std::memcpy(&size, &headerAt(position), sizeof(size));
  if (size == kSkip) {
    position += untilEnd(position);
    std::memcpy(&size, &headerAt(position), sizeof(size));
  }
  const std::uint64_t skipped = position - head_;
  const bool fits = published <= mask_ + 1 && published % sizeof(size) == 0 &&
                    skipped + sizeof(size) <= published && size <= copy_.size() &&
                    recordSize(size) <= published - skipped &&
                    recordSize(size) <= untilEnd(position);
  broken_ = broken_ || !fits;
  if (broken_) return nullptr;
  head_ = position;
  copySize_ = size;
  return data_.get() + (position & mask_) + sizeof(size);
}

std::size_t SpscRing::frontSize() const { return copied_ ? copySize_ : headerAt(head_); }

void SpscRing::pop() {
  head_ += recordSize(frontSize());
  copied_ = false;
  shared_->head.store(head_, std::memory_order_release);
}

}  // namespace suture::rt
