#include <suture/rt/latest_cell.h>

#include <cstring>

namespace suture::rt {

LatestCell::LatestCell(std::size_t size)
    : stride_((size + 63) & ~std::size_t{63}), data_(new std::byte[3 * stride_]) {
  std::memset(data_.get(), 0, 3 * stride_);
}

bool LatestCell::commit() {
  const std::uint32_t previous = shared_.exchange(writing_ | kFresh, std::memory_order_acq_rel);
  writing_ = previous & ~kFresh;
  return (previous & kFresh) != 0;
}

bool LatestCell::take() {
  if (!fresh()) return false;
  reading_ = shared_.exchange(reading_, std::memory_order_acq_rel) & ~kFresh;
  return true;
}

}  // namespace suture::rt
