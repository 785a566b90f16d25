#pragma once
// This copies the newest row of a state table, a part at a time.

#include <suture/rt/state/state_table.h>

#include <cstddef>
#include <span>

namespace suture::frame {

/// Belongs to the lane thread. Copies the columns of one row to their slots, a part at each turn,
/// so that the thread's other connections have their turns between.
class RowCopy {
 public:
  explicit RowCopy(const rt::StateTable& table) : table_(table) {}

  /// Begins with the newest row, of which `columns` are copied.
  void begin(std::span<std::byte* const> slots, rt::ColumnSet columns);
  /// Stops the copy where it is.
  void giveUp() { underWay_ = false; }
  bool underWay() const { return underWay_; }
  /// Copies some more; returns true if that was all.
  bool go();
  /// Returns what has been copied.
  const rt::StateTable::Row& row() const { return row_; }

 private:
  bool copyPart(std::size_t& most);
  void copyNewest();

  const rt::StateTable& table_;
  std::span<std::byte* const> slots_;
  rt::ColumnSet columns_ = 0;
  rt::StateTable::Row row_;
  unsigned column_ = 0;     // the one that is being copied
  std::size_t copied_ = 0;  // bytes of it, or unused
  bool underWay_ = false;
};

}  // namespace suture::frame
