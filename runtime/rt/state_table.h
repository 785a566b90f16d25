#pragma once
// The values a provider produces each cycle, readable by anyone at any time without a lock.

#include <suture/base/errors.h>
#include <suture/base/memory_block.h>
#include <suture/base/time.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

namespace suture {
class SharedSlot;
}

namespace suture::rt {

/// A set of columns, one bit each: at most 64 reads in a contract.
using ColumnSet = std::uint64_t;

/// A ring of rows in a sealed memory block, prefaulted, so that another process can map it
/// read-only. One writer thread; any number of readers, disturbed only if they are stopped for
/// nearly a whole lap.
///
/// Every word is an atomic: correct under the C++ memory model, and on x86 plain moves.
class StateTable {
 public:
  static constexpr unsigned kDefaultRows = 64;

  /// A column for each read of the contract: `columnSizes[i]` is the size of the slot of read i. At
  /// least `rows` rows: a power of two.
  /// Columns in `shared` hold counted pointers (base/shared_slot.h): of those only the newest is
  /// kept, and they are read under a lock.
  explicit StateTable(std::span<const std::uint32_t> columnSizes, unsigned rows = kDefaultRows,
                      ColumnSet shared = 0);
  ~StateTable();
  StateTable(const StateTable&) = delete;
  StateTable& operator=(const StateTable&) = delete;

  // --- writer ---

  /// Where to prepare column `column` of the next row. Private to the writer.
  std::byte* draft(unsigned column);
  /// Publishes the draft as a new row: of the columns in `valid` the values, of those in `tooLarge`
  /// the fact that they did not fit. All others say "not yet".
  void publish(Time stamp, ColumnSet valid, ColumnSet tooLarge);
  /// Columns that somebody has asked for. Never shrinks.
  ColumnSet demand() const { return demand_.load(std::memory_order_acquire); }

  // --- readers, any thread ---

  /// Asks for a column to be produced from now on. True if this is the first time.
  bool ask(unsigned column);
  /// Copies a column of the newest row. The stamp is when the row was published.
  Result<Time> read(unsigned column, std::byte* slot) const;
  /// Copies the newest row into `slots` (one pointer a column, nullptr: not wanted) and tells its
  /// columns.
  struct Row {
    std::uint64_t sequence = 0;
    Time stamp{};
    ColumnSet valid = 0, tooLarge = 0;
  };
  Row readRow(std::span<std::byte* const> slots) const;
  /// Number of rows published so far.
  std::uint64_t rows() const { return newest_.load(std::memory_order_acquire); }

  std::size_t columns() const { return columns_.size(); }
  std::uint32_t columnSize(unsigned column) const { return columns_[column].size; }
  /// Does a copy of the column have to be released?
  bool isShared(unsigned column) const { return (shared_ >> column & 1) != 0; }

 private:
  using Word = std::atomic<std::uint64_t>;
  struct Column {
    std::uint32_t offset, size;
  };
  struct RowHeader {
    Word sequence;  // of the complete row that lies here; 0 while it is written
    Word stamp, valid, tooLarge;
  };

  void publishShared(ColumnSet valid);
  void loadColumn(unsigned column, RowHeader& header, std::byte* slot) const;
  RowHeader& headerAt(std::uint64_t sequence) const;
  Word* payloadOf(RowHeader& header) const { return reinterpret_cast<Word*>(&header + 1); }
  template <class Copy>
  bool tryReadNewest(Row& row, const Copy& copy) const;
  template <class Copy>
  Row readNewest(const Copy& copy) const;

  std::vector<Column> columns_;
  std::size_t rowBytes_;
  std::size_t rowMask_;
  std::vector<std::byte> draft_;
  const ColumnSet shared_;
  mutable std::mutex newestSharedMutex_;
  std::vector<SharedSlot*> newestShared_;  // by column
  MemoryBlock memory_;
  std::atomic<std::uint64_t> newest_{0};
  std::atomic<ColumnSet> demand_{0};
};

}  // namespace suture::rt
