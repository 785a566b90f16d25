#include <suture/rt/queue/latest_cell.h>

namespace suture::rt {

LatestCell::LatestCell(std::size_t size, Arena& arena)
    : stride_((size + 63) & ~std::size_t{63}),
      data_(arena.take(kBuffers * stride_)),
      shared_(arena.make<std::atomic<std::uint32_t>>()) {
  if (arena.fresh()) shared_->store(1, std::memory_order_release);
  if (arena.foreign()) copy_.resize(stride_);
}

bool LatestCell::commit() {
  const std::uint32_t previous = shared_->exchange(writing_ | kFresh, std::memory_order_acq_rel);
  writing_ = indexIn(previous);
  return (previous & kFresh) != 0;
}

bool LatestCell::takeNewest() {
  if (!fresh()) return false;
  reading_ = indexIn(shared_->exchange(reading_, std::memory_order_acq_rel));
  return true;
}

}  // namespace suture::rt
