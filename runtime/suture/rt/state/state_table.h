#pragma once
// These are the values that a provider produces each cycle; any thread may read them at any time
// without a lock.

#include <suture/base/errors.h>
#include <suture/base/memory_block.h>
#include <suture/base/slots/bounded_level.h>
#include <suture/base/time.h>
#include <suture/rt/state/row_columns.h>
#include <suture/rt/state/shared_columns.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace suture::rt {

/// One writer thread; any number of readers, which are disturbed only if they are stopped for
/// nearly a whole lap. Keeps a ring of rows in prefaulted memory, which other processes may map
/// read-only.
///
/// Every word is an atomic, so that this is correct under the C++ memory model; on x86 they are
/// plain moves.
class StateTable {
 public:
  static constexpr unsigned kDefaultRows = 64;

  /// Says who reads the table.
  enum class Readers : std::uint8_t {
    Here,       ///< this process only: the rows lie on the heap
    Elsewhere,  ///< other processes too
  };

  /// Makes a column for each read of the contract: `columnSizes[i]` is the size of the slot of read
  /// i. Keeps at least `rows` rows, rounded up to a power of two.
  /// `shared` says which columns hold counted pointers (base/slots/shared_slot.h): of those only
  /// the newest value is kept, and the table is used under a lock.
  /// `levels` says, by column, which parts need not be copied; if it is empty, all of each column
  /// is copied.
  explicit StateTable(std::span<const std::uint32_t> columnSizes, unsigned rows = kDefaultRows,
                      ColumnSet shared = 0, Readers readers = Readers::Elsewhere,
                      std::span<const BoundedLevels> levels = {});
  /// For readers only. Reads a table that another process writes, in the memory() of that table.
  /// Columns that are asked for here are put into `demand`; the caller must ask for them over
  /// there. Throws SetupError if the memory has no room for `rows` rows.
  StateTable(std::span<const std::uint32_t> columnSizes, unsigned rows,
             std::shared_ptr<MemoryBlock> memory, std::shared_ptr<std::atomic<ColumnSet>> demand,
             std::span<const BoundedLevels> levels = {});
  ~StateTable();
  StateTable(const StateTable&) = delete;
  StateTable& operator=(const StateTable&) = delete;

  /// Before the first row and the first reader. Makes the table keep at least `rows` rows instead.
  void resize(unsigned rows);

  // --- writer ---

  /// Returns where to prepare column `column` of the next row. Readers do not see it.
  std::byte* draft(unsigned column);
  /// Publishes the draft as a new row: the values of the valid columns, and for the others why they
  /// have none. Stamps never go back: an earlier stamp is replaced by that of the row before.
  void publish(Time stamp, const RowColumns& columns);
  /// This is a value that lies elsewhere, of a column that is not shared.
  struct Value {
    const std::byte* bytes = nullptr;
    std::size_t stored = 0;  ///< how many of them storeAhead() has stored
  };
  /// Publishes a row of values that lie elsewhere, by column.
  void publish(Time stamp, const RowColumns& columns, std::span<const Value> values);
  /// Stores the first `bytes` of a value of the next row, which must be whole words or all of it.
  /// So a large value can be stored in several steps, and none of them takes as long as the whole.
  void storeAhead(unsigned column, Value& value, std::size_t bytes);
  /// Returns the columns that any reader has asked for. The set never shrinks.
  ColumnSet demand() const { return demand_->load(std::memory_order_acquire); }

  // --- readers, any thread ---

  /// Asks for a column to be produced from now on. Returns true if this is the first time.
  bool ask(unsigned column) { return askAll(ColumnSet{1} << column); }
  /// Asks for several columns, which are produced from the same row on. Returns true if this is the
  /// first time for one of them.
  bool askAll(ColumnSet columns);
  /// Copies a column of the newest row, and returns the stamp with which that row was published.
  Result<Time> read(unsigned column, std::byte* slot) const;
  /// Copies a column as it was at `at`, that is, of the last row stamped at or before it. Returns
  /// NotYet if the value had not been produced by then, TooOld if that row has been overwritten.
  /// Takes as many steps as the number of rows has bits.
  Result<Time> readAt(Time at, unsigned column, std::byte* slot) const;
  /// Copies the newest row into `slots` (one pointer for each column; nullptr if it is not wanted)
  /// and says which columns have a value.
  struct Row : RowColumns {
    std::uint64_t sequence = 0;  ///< 0: there is none
    Time stamp{};
    bool tooOld = false;  ///< there was one, and it has been overwritten

    /// Returns why there is no value of `column`; Errc{} if there is one.
    Errc missing(unsigned column) const;
  };
  Row readRow(std::span<std::byte* const> slots) const;
  /// Copies bytes of a column that is not shared, of a row that was read before. `offset` is that
  /// of a word; the part ends at a word or with the column. Returns false if the row has been
  /// overwritten.
  bool readPart(const Row& row, unsigned column, std::size_t offset, std::span<std::byte> to) const;
  /// Does what readRow() does, for the last row stamped at or before `at`.
  Row readRowAt(Time at, std::span<std::byte* const> slots) const;
  /// Does what readRow() does, for row number `sequence`, counted from 1.
  Row readRowNumber(std::uint64_t sequence, std::span<std::byte* const> slots) const;
  /// Returns the number of rows published so far; at most kMostRows, whatever another process has
  /// written.
  static constexpr std::uint64_t kMostRows = std::uint64_t{1} << 62;
  std::uint64_t rows() const {
    return std::min(newest_->load(std::memory_order_acquire), kMostRows);
  }
  /// Returns how many rows it keeps. The writer may be overwriting the oldest of them.
  std::uint64_t capacity() const { return rowMask_ + 1; }

  std::size_t rowBytes() const { return rowBytes_; }
  std::size_t columns() const { return columns_.size(); }
  /// Returns those of `columns` that exist.
  ColumnSet existing(ColumnSet columns) const;
  std::uint32_t columnSize(unsigned column) const { return columns_[column].size; }
  /// Returns which parts of the column need not be copied.
  BoundedLevels columnLevels(unsigned column) const { return columns_[column].levels; }
  /// Returns true if a copy of the column must be released.
  bool isShared(unsigned column) const { return shared_.contains(column); }
  /// Returns the memory where the rows lie, if other processes may read them; nullptr if not, and
  /// if any column is shared.
  const std::shared_ptr<MemoryBlock>& memory() const { return memory_; }
  /// Returns how much memory a table takes up.
  static std::size_t bytesFor(std::span<const std::uint32_t> columnSizes, unsigned rows);

 private:
  using Word = std::atomic<std::uint64_t>;
  struct Column {
    std::uint32_t offset, size;
    BoundedLevels levels;
  };
  struct alignas(64) Line {
    std::byte bytes[64];
  };
  struct RowHeader {
    Word sequence;  // the complete row that lies here has this number; 0 while it is written
    Word stamp, valid, tooLarge, invalid;
  };

  static std::size_t bytesOfRow(std::span<const std::uint32_t> columnSizes);
  void addColumns(std::span<const std::uint32_t> sizes, std::span<const BoundedLevels> levels);
  void layOut(std::byte* memory);
  template <class Store>
  void publishBy(const Store& store, Time stamp, const RowColumns& columns);
  void loadColumn(unsigned column, RowHeader& header, std::byte* slot) const;
  RowHeader& headerAt(std::uint64_t sequence) const;
  Word* payloadOf(RowHeader& header) const { return reinterpret_cast<Word*>(&header + 1); }
  static Row overwritten();
  std::uint64_t oldest(std::uint64_t newest) const;
  bool stampOf(std::uint64_t sequence, Time& stamp) const;
  Row findAt(Time at) const;
  template <class Copy>
  bool tryRead(Row& row, const Copy& copy) const;
  template <class Copy>
  Row readNewest(const Copy& copy) const;
  template <class Copy>
  Row readAt(Time at, const Copy& copy) const;
  auto copying(unsigned column, std::byte* slot) const;
  auto copying(std::span<std::byte* const> slots) const;

  std::vector<Column> columns_;
  const Readers readers_;
  std::size_t rowBytes_;
  std::size_t rowMask_ = 0;
  std::vector<std::byte> draft_;
  SharedColumns shared_;
  std::shared_ptr<MemoryBlock> memory_;  // or else here_
  std::unique_ptr<Line[]> here_;
  Word* newest_ = nullptr;     // at the beginning of the memory
  std::byte* rows_ = nullptr;  // behind it
  Time lastStamp_{};           // the writer's
  std::shared_ptr<std::atomic<ColumnSet>> demand_;
};

}  // namespace suture::rt
