#include <suture/base/slots/shared_slot.h>
#include <suture/rt/state/shared_columns.h>

#include <utility>

namespace suture::rt {

SharedColumns::SharedColumns(std::uint64_t which, std::size_t columns)
    : which_(which), newest_(which == 0 ? 0 : columns, nullptr) {}

SharedColumns::~SharedColumns() {
  for (SharedSlot* const slot : newest_) {
    if (slot != nullptr) slot->release();
  }
}

void SharedColumns::take(unsigned column, std::byte* draft) {
  SharedSlot* const value = sharedSlotIn(draft);
  if (value == nullptr) return;
  putSharedSlot(draft, nullptr);
  SharedSlot* const old = std::exchange(newest_[column], value);
  if (old != nullptr) old->release();
}

void SharedColumns::copy(unsigned column, std::byte* slot) const {
  releaseSharedSlot(slot);
  newest_[column]->retain();
  putSharedSlot(slot, newest_[column]);
}

}  // namespace suture::rt
