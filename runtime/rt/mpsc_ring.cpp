#include <suture/rt/mpsc_ring.h>

#include <bit>
#include <cstring>
#include <new>

namespace suture::rt {

// Each cell carries the position at which it may be used next: equal to a producer's position it is
// free, one more it is published. A cell comes round again one lap (mask_ + 1) later.
MpscRing::MpscRing(std::size_t cells, std::size_t cellSize)
    : mask_(std::bit_ceil(cells) - 1),
      stride_(sizeof(std::uint64_t) + ((cellSize + 7) & ~std::size_t{7})),
      data_(new std::byte[(mask_ + 1) * stride_]) {
  std::memset(data_.get(), 0, (mask_ + 1) * stride_);
  for (std::uint64_t i = 0; i <= mask_; ++i) new (&turnAt(i)) std::atomic<std::uint64_t>(i);
}

std::byte* MpscRing::claim() {
  std::uint64_t position = tail_.load(std::memory_order_relaxed);
  while (true) {
    const std::uint64_t turn = turnAt(position).load(std::memory_order_acquire);
    if (turn == position) {
      if (tail_.compare_exchange_weak(position, position + 1, std::memory_order_relaxed)) {
        return reinterpret_cast<std::byte*>(&turnAt(position)) + sizeof(std::uint64_t);
      }
    } else if (turn < position) {
      return nullptr;
    } else {
      position = tail_.load(std::memory_order_relaxed);
    }
  }
}

void MpscRing::commit(std::byte* cell) {
  auto& turn = *reinterpret_cast<std::atomic<std::uint64_t>*>(cell - sizeof(std::uint64_t));
  turn.store(turn.load(std::memory_order_relaxed) + 1, std::memory_order_release);
}

const std::byte* MpscRing::front() const {
  auto& turn = turnAt(head_);
  if (turn.load(std::memory_order_acquire) != head_ + 1) return nullptr;
  return reinterpret_cast<const std::byte*>(&turn) + sizeof(std::uint64_t);
}

void MpscRing::pop() {
  turnAt(head_).store(head_ + mask_ + 1, std::memory_order_release);
  ++head_;
}

}  // namespace suture::rt
