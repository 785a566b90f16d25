// This is a ring that hands out another process's memory as it is: the fuzzer of shared memory must
// see it change.

#include <suture/rt/queue/mpsc_ring.h>

#include <bit>
#include <new>

namespace suture::rt {

MpscRing::MpscRing(std::size_t cells, std::size_t cellSize, Arena& arena)
    : mask_(std::bit_ceil(cells) - 1),
      stride_(sizeof(std::uint64_t) + ((cellSize + 7) & ~std::size_t{7})),
      data_(arena.take((mask_ + 1) * stride_)) {
  if (!arena.fresh()) return;
  for (std::uint64_t i = 0; i <= mask_; ++i) new (&sequenceAt(i)) std::atomic<std::uint64_t>(i);
}

bool MpscRing::pending() const {
  return sequenceAt(head_).load(std::memory_order_acquire) == head_ + 1;
}

void MpscRing::release(std::uint64_t place) {
  auto& sequence = sequenceAt(place);
  sequence.store(sequence.load(std::memory_order_relaxed) + mask_ + 1, std::memory_order_release);
}

void MpscRing::pop() {
  sequenceAt(head_).store(head_ + mask_ + 1, std::memory_order_release);
  ++head_;
}

}  // namespace suture::rt
