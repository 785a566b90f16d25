#pragma once
// This has room for the values of a row.

#include <suture/component/contract/interface_info.h>
#include <suture/rt/state/row_columns.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace suture {

/// One thread. Holds the slots of a contract's columns without gaps, each at a word. It has none
/// before they are asked for.
class RowSlots {
 public:
  /// `head` bytes, in whole words, are free in front of them.
  explicit RowSlots(const InterfaceInfo& contract, std::size_t head = 0);

  /// Returns where the values of `columns` go; other columns get no room and null. All is zero if
  /// the columns differ from the last time.
  std::span<std::byte* const> of(rt::ColumnSet columns);
  /// Returns what the last of() did.
  std::span<std::byte* const> slots() const { return slots_; }
  /// Returns the size, head included.
  std::size_t bytes() const { return bytes_; }
  std::size_t sizeOf(std::size_t column) const { return sizes_[column]; }
  std::size_t columns() const { return sizes_.size(); }
  /// Returns all of the memory, which begins with the head.
  std::span<std::byte> memory() {
    return {reinterpret_cast<std::byte*>(memory_.data()), memory_.size() * sizeof(std::uint64_t)};
  }

 private:
  const std::size_t head_;
  std::size_t bytes_;
  std::vector<std::uint32_t> sizes_;  // by column
  rt::ColumnSet columns_ = 0;         // for which there is room
  std::vector<std::uint64_t> memory_;
  std::vector<std::byte*> slots_;
};

}  // namespace suture
