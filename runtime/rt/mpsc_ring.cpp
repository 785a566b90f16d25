#include <suture/rt/mpsc_ring.h>

#include <bit>
#include <cstring>
#include <new>

namespace suture::rt {

MpscRing::MpscRing(std::size_t cells, std::size_t cellSize)
    : mask_(std::bit_ceil(cells) - 1),
      stride_(sizeof(std::uint64_t) + ((cellSize + 7) & ~std::size_t{7})),
      data_(new std::byte[(mask_ + 1) * stride_]) {
  std::memset(data_.get(), 0, (mask_ + 1) * stride_);
  for (std::uint64_t i = 0; i <= mask_; ++i) new (&turnAt(i)) std::atomic<std::uint64_t>(i);
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
