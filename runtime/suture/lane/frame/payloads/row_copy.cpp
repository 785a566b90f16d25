#include <suture/base/slots/used_parts.h>
#include <suture/base/words.h>
#include <suture/lane/frame/bytes/frame.h>
#include <suture/lane/frame/payloads/row_copy.h>

#include <algorithm>

namespace suture::frame {

void RowCopy::begin(std::span<std::byte* const> slots, rt::ColumnSet columns) {
  slots_ = slots;
  columns_ = columns;
  row_ = table_.readRow({});
  row_.keep(columns);
  column_ = 0;
  copied_ = 0;
  underWay_ = true;
}

bool RowCopy::go() {
  std::size_t most = kMostPayload;
  for (; column_ < slots_.size(); ++column_, copied_ = 0) {
    if (row_.hasValue(column_) && !copyPart(most)) return false;
  }
  underWay_ = false;
  return true;
}

/// Returns true if all of the column has been copied. Leaves the unused words of the slot
/// unchanged.
bool RowCopy::copyPart(std::size_t& most) {
  std::byte* const slot = slots_[column_];
  const std::size_t size = table_.columnSize(column_);
  const BoundedLevels levels = table_.columnLevels(column_);
  for (;;) {
    const auto [begin, usedEnd] = nextUsedWords(slot, copied_, size, levels);
    if (begin == size) return true;
    if (most == 0) return false;
    const std::size_t end = std::min(usedEnd, begin + most);
    if (!table_.readPart(row_, column_, begin, {slot + begin, end - begin})) {
      copyNewest();
      return true;
    }
    copied_ = end;
    most -= std::min(most, wordBytes(end - begin));
  }
}

/// Copies the newest row at once, because the provider has meanwhile overwritten the row that was
/// being copied.
void RowCopy::copyNewest() {
  row_ = table_.readRow(slots_);
  row_.keep(columns_);
  column_ = static_cast<unsigned>(slots_.size()) - 1;
}

}  // namespace suture::frame
