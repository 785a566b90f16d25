#include <suture/base/words.h>
#include <suture/lane/carrier/row_slots.h>

namespace suture {

RowSlots::RowSlots(const InterfaceInfo& contract, std::size_t head) : head_(head), bytes_(head) {
  for (const CommandInfo& one : contract.commands) {
    if (one.column < 0) continue;
    sizes_.push_back(one.resultSize);
    bytes_ += wordBytes(one.resultSize);
  }
  slots_.resize(sizes_.size());
}

std::span<std::byte* const> RowSlots::of(rt::ColumnSet columns) {
  if (columns == columns_ && !memory_.empty()) return slots_;
  columns_ = columns;
  // The memory is cleared, so that no value of a column that was wanted before stays in it.
  memory_.assign(bytes_ / sizeof(std::uint64_t), 0);
  std::byte* end = memory().data() + head_;
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const bool wanted = (columns >> i & 1) != 0;
    slots_[i] = wanted ? end : nullptr;
    if (wanted) end += wordBytes(sizes_[i]);
  }
  return slots_;
}

}  // namespace suture
