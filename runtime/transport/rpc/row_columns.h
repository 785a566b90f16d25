#pragma once
// What a row that came over rpc says of its columns.

#include <suture/base/errors.h>
#include <suture/rt/state_table.h>

namespace suture::rpc {

/// Each column is in one set at most. On the wire one that the contract does not admit is
/// `evaluated` and `tooLarge`.
struct RowColumns {
  RowColumns(rt::ColumnSet evaluated, rt::ColumnSet notSent)
      : valid(evaluated & ~notSent), tooLarge(notSent & ~evaluated), invalid(evaluated & notSent) {}

  bool hasValue(unsigned column) const { return (valid >> column & 1) != 0; }
  /// Takes the value of `column` back: it could not be read, because of `error`.
  void refuse(unsigned column, Errc error) {
    const rt::ColumnSet bit = rt::ColumnSet{1} << column;
    valid &= ~bit;
    (error == Errc::TooLarge ? tooLarge : invalid) |= bit;
  }

  rt::ColumnSet valid, tooLarge, invalid;
};

}  // namespace suture::rpc
