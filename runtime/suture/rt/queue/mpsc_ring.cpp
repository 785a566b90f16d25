#include <suture/base/words.h>
#include <suture/rt/queue/mpsc_ring.h>

#include <bit>
#include <new>

namespace suture::rt {

MpscRing::MpscRing(std::size_t cells, std::size_t cellSize, Arena& arena)
    : mask_(std::bit_ceil(cells) - 1),
      stride_(sizeof(std::uint64_t) + wordBytes(cellSize)),
      data_(arena.take((mask_ + 1) * stride_)) {
  if (arena.foreign()) copy_.resize(stride_ - sizeof(std::uint64_t));
  if (!arena.fresh()) return;
  for (std::uint64_t i = 0; i <= mask_; ++i) new (&sequenceAt(i)) std::atomic<std::uint64_t>(i);
}

bool MpscRing::pending() const {
  return sequenceAt(head_).load(std::memory_order_acquire) == head_ + 1;
}

// Looks at no more cells than there are, because another process may have written any numbers.
std::uint64_t MpscRing::end() const {
  std::uint64_t position = head_;
  while (position - head_ <= mask_ &&
         sequenceAt(position).load(std::memory_order_acquire) == position + 1) {
    ++position;
  }
  return position;
}

void MpscRing::release(std::uint64_t place) {
  auto& sequence = sequenceAt(place);
  sequence.store(sequence.load(std::memory_order_relaxed) + mask_ + 1, std::memory_order_release);
}

void MpscRing::pop() {
  copied_ = false;
  sequenceAt(head_).store(head_ + mask_ + 1, std::memory_order_release);
  ++head_;
}

}  // namespace suture::rt
