#include <suture/rt/due_bells.h>

#include <algorithm>

namespace suture::rt {

std::size_t DueBells::firstSlot(const Doorbell& bell) {
  constexpr std::uint64_t kGoldenRatio = 0x9e3779b97f4a7c15;  // Fibonacci hashing: Knuth, vol. 3
  return reinterpret_cast<std::uintptr_t>(&bell) * kGoldenRatio >> (64 - kSlotBits);
}

void DueBells::add(Doorbell& bell, RungFor what, SharedFlag* untaken) {
  std::size_t slot = firstSlot(bell);
  while (slots_[slot] < count_ && due_[slots_[slot]].slot == slot) {
    Due& due = due_[slots_[slot]];
    if (due.bell == &bell) {
      due.what = std::max(due.what, what);
      if (due.untaken != untaken) due.untaken = nullptr;
      return;
    }
    slot = (slot + 1) % kSlots;
  }
  if (count_ == kCapacity) {
    bell.ring(what);
    return;
  }
  bell.tellDue();
  slots_[slot] = static_cast<std::uint16_t>(count_);
  due_[count_++] = {&bell, static_cast<std::uint32_t>(slot), what, untaken};
}

void DueBells::ringAll() {
  if (count_ == 0) return;
  for (std::size_t i = 0; i < count_; ++i) {
    const Due& due = due_[i];
    const bool wanted = due.untaken == nullptr || due.untaken->take(std::memory_order_acq_rel);
    if (wanted) due.bell->ring(due.what);
  }
  count_ = 0;
  if (VirtualTime* const time = virtualTime(); time != nullptr) time->settle();
}

}  // namespace suture::rt
