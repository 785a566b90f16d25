#pragma once
// This is what a row of a state table says of its columns.

#include <suture/base/errors.h>

#include <cstdint>

namespace suture::rt {

/// A ColumnSet has one bit for each column: a contract has at most 64 reads.
using ColumnSet = std::uint64_t;

/// Each column is in one set at most; if it is in none, it has not been produced yet. Processes
/// send this to each other as it lies in memory.
struct RowColumns {
  ColumnSet valid = 0;     ///< they have a value
  ColumnSet tooLarge = 0;  ///< their value did not fit its declared capacity
  ColumnSet invalid = 0;   ///< the contract does not admit their value

  bool hasValue(unsigned column) const { return (valid >> column & 1) != 0; }
  bool any() const { return (valid | tooLarge | invalid) != 0; }

  /// Enters how producing or reading the value of `column` ended; Errc{} means success.
  void enter(unsigned column, Errc outcome) {
    const ColumnSet bit = ColumnSet{1} << column;
    valid &= ~bit;
    (outcome == Errc{} ? valid : outcome == Errc::TooLarge ? tooLarge : invalid) |= bit;
  }
  /// Removes all columns that are not in `columns`.
  void keep(ColumnSet columns) {
    valid &= columns;
    tooLarge &= columns;
    invalid &= columns;
  }
};

}  // namespace suture::rt
