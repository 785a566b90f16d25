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

/// Returns whether that was all of the column.
bool RowCopy::copyPart(std::size_t& most) {
  const std::size_t part = std::min(table_.columnSize(column_) - copied_, most);
  if (!table_.readPart(row_, column_, copied_, {slots_[column_] + copied_, part})) {
    copyNewest();
    return true;
  }
  copied_ += part;
  most -= std::min(most, wordBytes(part));
  return copied_ == table_.columnSize(column_);
}

/// The provider has gone round all rows meanwhile: the newest one is copied at once.
void RowCopy::copyNewest() {
  row_ = table_.readRow(slots_);
  row_.keep(columns_);
  column_ = static_cast<unsigned>(slots_.size()) - 1;
}

}  // namespace suture::frame
