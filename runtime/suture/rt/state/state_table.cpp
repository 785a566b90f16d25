#include <suture/base/slots/shared_slot.h>
#include <suture/base/slots/used_parts.h>
#include <suture/base/words.h>
#include <suture/rt/state/state_table.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <new>
#include <string>

namespace suture::rt {
namespace {

// The block begins with the number of the newest row, on a cache line of its own.
constexpr std::size_t kHeaderBytes = 64;

// Row copies go word by word through atomics; the private side is ordinary memory.
void storeWords(std::atomic<std::uint64_t>* to, const std::byte* from, std::size_t bytes) {
  const std::size_t whole = bytes / 8, rest = bytes % 8;
  for (std::size_t i = 0; i < whole; ++i) {
    std::uint64_t word;
    std::memcpy(&word, from + 8 * i, 8);
    to[i].store(word, std::memory_order_release);
  }
  if (rest == 0) return;
  std::uint64_t word = 0;
  std::memcpy(&word, from + 8 * whole, rest);
  to[whole].store(word, std::memory_order_release);
}

void loadWords(std::byte* to, const std::atomic<std::uint64_t>* from, std::size_t bytes) {
  const std::size_t whole = bytes / 8, rest = bytes % 8;
  for (std::size_t i = 0; i < whole; ++i) {
    const std::uint64_t word = from[i].load(std::memory_order_acquire);
    std::memcpy(to + 8 * i, &word, 8);
  }
  if (rest == 0) return;
  const std::uint64_t word = from[whole].load(std::memory_order_acquire);
  std::memcpy(to + 8 * whole, &word, rest);
}

// Stores the used parts of a value behind `place`, in whole words. It reads nothing of the unused
// parts.
void storeUsed(std::atomic<std::uint64_t>* to, const std::byte* from, std::size_t place,
               std::size_t size, BoundedLevels levels) {
  while (place < size) {
    const auto [begin, end] = nextUsedWords(from, place, size, levels);
    storeWords(to + begin / 8, from + begin, end - begin);
    place = end;
  }
}

// Loads the used parts of a value. Each size is read from the copy, because the original may
// change; if it does, the caller discards the row.
void loadUsed(std::byte* to, const std::atomic<std::uint64_t>* from, std::size_t size,
              BoundedLevels levels) {
  for (std::size_t place = 0; place < size;) {
    const auto [begin, end] = nextUsedWords(to, place, size, levels);
    loadWords(to + begin, from + begin / 8, end - begin);
    place = end;
  }
}

std::size_t payloadBytes(std::span<const std::uint32_t> columnSizes) {
  std::size_t bytes = 0;
  for (const std::uint32_t size : columnSizes) bytes += wordBytes(size);
  return bytes;
}

// Bounds a stamp so that its age can be computed, because another process may have written
// anything.
Time boundedStamp(std::uint64_t stamp) {
  return fromNanoseconds(std::max<std::int64_t>(0, static_cast<std::int64_t>(stamp)));
}

}  // namespace

StateTable::StateTable(std::span<const std::uint32_t> columnSizes, unsigned rows, ColumnSet shared,
                       Readers readers, std::span<const BoundedLevels> levels)
    : readers_(readers),
      rowBytes_(bytesOfRow(columnSizes)),
      draft_(payloadBytes(columnSizes)),
      shared_(shared, columnSizes.size()),
      demand_(std::make_shared<std::atomic<ColumnSet>>(0)) {
  addColumns(columnSizes, levels);
  resize(rows);
}

StateTable::StateTable(std::span<const std::uint32_t> columnSizes, unsigned rows,
                       std::shared_ptr<MemoryBlock> memory,
                       std::shared_ptr<std::atomic<ColumnSet>> demand,
                       std::span<const BoundedLevels> levels)
    : readers_(Readers::Elsewhere),
      rowBytes_(bytesOfRow(columnSizes)),
      rowMask_(std::bit_ceil(rows) - 1),
      shared_(0, columnSizes.size()),
      demand_(std::move(demand)) {
  addColumns(columnSizes, levels);
  if (const std::size_t needed = bytesFor(columnSizes, rows); memory->size() < needed) {
    throw SetupError(
        "read a state table of " + std::to_string(rows) + " rows",
        "the memory has " + std::to_string(memory->size()) + " bytes of " + std::to_string(needed),
        "Build both processes from the same release");
  }
  memory_ = std::move(memory);
  layOut(memory_->data());
}

void StateTable::addColumns(std::span<const std::uint32_t> sizes,
                            std::span<const BoundedLevels> levels) {
  std::uint32_t offset = 0;
  for (const std::uint32_t size : sizes) {
    const std::size_t column = columns_.size();
    columns_.push_back({offset, size, column < levels.size() ? levels[column] : BoundedLevels{}});
    offset += static_cast<std::uint32_t>(wordBytes(size));
  }
}

std::size_t StateTable::bytesOfRow(std::span<const std::uint32_t> columnSizes) {
  return (sizeof(RowHeader) + payloadBytes(columnSizes) + 63) & ~std::size_t{63};
}

std::size_t StateTable::bytesFor(std::span<const std::uint32_t> columnSizes, unsigned rows) {
  return kHeaderBytes + bytesOfRow(columnSizes) * std::bit_ceil(rows);
}

void StateTable::layOut(std::byte* memory) {
  newest_ = reinterpret_cast<Word*>(memory);
  rows_ = memory + kHeaderBytes;
}

// Changes nothing until it has the memory, because who has asked for too much may go on.
void StateTable::resize(unsigned rows) {
  const std::size_t kept = std::bit_ceil(std::size_t{rows});
  const std::size_t bytes = kHeaderBytes + rowBytes_ * kept;
  if (readers_ == Readers::Here) {  // whole pages would be more than the rows, mostly
    here_ = std::make_unique<Line[]>(bytes / sizeof(Line));
    layOut(here_[0].bytes);
  } else {
    memory_ = std::make_shared<MemoryBlock>("suture-state", bytes, MemoryBlock::Others::Read);
    layOut(memory_->data());
  }
  rowMask_ = kept - 1;
  new (newest_) Word{0};
  for (std::size_t i = 0; i <= rowMask_; ++i) new (rows_ + i * rowBytes_) RowHeader{};
}

StateTable::~StateTable() {
  if (draft_.empty()) return;
  for (unsigned i = 0; i < columns_.size(); ++i) draft(i);
}

std::byte* StateTable::draft(unsigned column) {
  std::byte* const memory = draft_.data() + columns_[column].offset;
  if (isShared(column)) releaseSharedSlot(memory);  // an unpublished row held it
  return memory;
}

void StateTable::loadColumn(unsigned column, RowHeader& header, std::byte* slot) const {
  const auto& [offset, size, levels] = columns_[column];
  if (isShared(column)) {
    shared_.copy(column, slot);
  } else {
    loadUsed(slot, payloadOf(header) + offset / 8, size, levels);
  }
}

ColumnSet StateTable::existing(ColumnSet columns) const {
  return columns_.empty() ? 0 : columns & ~ColumnSet{0} >> (64 - columns_.size());
}

StateTable::RowHeader& StateTable::headerAt(std::uint64_t sequence) const {
  return *reinterpret_cast<RowHeader*>(rows_ + (sequence & rowMask_) * rowBytes_);
}

// `store(column, place)` fills the words of a column.
template <class Store>
void StateTable::publishBy(const Store& store, Time stamp, const RowColumns& columns) {
  const auto lock = shared_.lock();
  const std::uint64_t sequence = newest_->load(std::memory_order_relaxed) + 1;
  lastStamp_ = std::max(lastStamp_, stamp);
  RowHeader& header = headerAt(sequence);
  header.sequence.store(0, std::memory_order_relaxed);
  header.stamp.store(static_cast<std::uint64_t>(toNanoseconds(lastStamp_)),
                     std::memory_order_release);
  header.valid.store(columns.valid, std::memory_order_release);
  header.tooLarge.store(columns.tooLarge, std::memory_order_release);
  header.invalid.store(columns.invalid, std::memory_order_release);
  for (unsigned i = 0; i < columns_.size(); ++i) {
    if (columns.hasValue(i)) store(i, payloadOf(header) + columns_[i].offset / 8);
  }
  header.sequence.store(sequence, std::memory_order_release);
  newest_->store(sequence, std::memory_order_release);
}

void StateTable::publish(Time stamp, const RowColumns& columns) {
  const auto store = [this](unsigned column, Word* place) {
    const auto& [offset, size, levels] = columns_[column];
    std::byte* const draft = draft_.data() + offset;
    if (isShared(column)) return shared_.take(column, draft);
    storeUsed(place, draft, 0, size, levels);
  };
  publishBy(store, stamp, columns);
}

void StateTable::publish(Time stamp, const RowColumns& columns, std::span<const Value> values) {
  const auto store = [&](unsigned column, Word* place) {
    const auto [bytes, stored] = values[column];
    const auto& [offset, size, levels] = columns_[column];
    storeUsed(place, bytes, stored, size, levels);
  };
  publishBy(store, stamp, columns);
}

void StateTable::storeAhead(unsigned column, Value& value, std::size_t bytes) {
  const std::size_t offset = columns_[column].offset, size = columns_[column].size;
  RowHeader& header = headerAt(newest_->load(std::memory_order_relaxed) + 1);
  header.sequence.store(0, std::memory_order_relaxed);
  const std::size_t stored = value.stored, end = std::min<std::size_t>(bytes, size);
  if (end <= stored) return;
  storeWords(payloadOf(header) + (offset + stored) / 8, value.bytes + stored, end - stored);
  value.stored = end;
}

bool StateTable::askAll(ColumnSet columns) {
  if ((columns & ~demand_->load(std::memory_order_relaxed)) == 0) return false;
  return (columns & ~demand_->fetch_or(columns, std::memory_order_acq_rel)) != 0;
}

StateTable::Row StateTable::overwritten() {
  Row row;
  row.tooOld = true;
  return row;
}

Errc StateTable::Row::missing(unsigned column) const {
  if (hasValue(column)) return Errc{};
  if (tooLarge >> column & 1) return Errc::TooLarge;
  if (invalid >> column & 1) return Errc::Invalid;
  return tooOld ? Errc::TooOld : Errc::NotYet;
}

// Runs `copy(header, row)` on row number `row.sequence`, and returns true if the row stayed whole
// meanwhile.
template <class Copy>
bool StateTable::tryRead(Row& row, const Copy& copy) const {
  const std::uint64_t sequence = row.sequence;
  RowHeader& header = headerAt(sequence);
  if (header.sequence.load(std::memory_order_acquire) != sequence) return false;
  row.stamp = boundedStamp(header.stamp.load(std::memory_order_acquire));
  row.valid = header.valid.load(std::memory_order_acquire);
  row.tooLarge = header.tooLarge.load(std::memory_order_acquire);
  row.invalid = header.invalid.load(std::memory_order_acquire);
  if (shared_.which() != 0 && sequence != newest_->load(std::memory_order_relaxed)) {
    row.tooOld = (row.valid & shared_.which()) != 0;
    row.valid &= ~shared_.which();
  }
  copy(header, row);
  return header.sequence.load(std::memory_order_relaxed) == sequence;
}

// A reader fails only if the writer went nearly a whole lap while it copied; each attempt starts
// from the beginning.
constexpr int kAttempts = 100;

template <class Copy>
StateTable::Row StateTable::readNewest(const Copy& copy) const {
  Row row;  // returned without a copy, which would cost as much as all the rest
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    row.tooOld = false;
    row.sequence = rows();
    if (row.sequence == 0 || tryRead(row, copy)) return row;
  }
  row = Row{};
  return row;
}

// Returns the number of the oldest row that the ring holds whole. It lies in the slot that is
// written next, so the writer may be about to overwrite it.
std::uint64_t StateTable::oldest(std::uint64_t newest) const {
  return newest > rowMask_ ? newest - rowMask_ : 1;
}

bool StateTable::stampOf(std::uint64_t sequence, Time& stamp) const {
  Row row;
  row.sequence = sequence;
  const bool whole = tryRead(row, [](RowHeader&, const Row&) {});
  stamp = row.stamp;
  return whole;
}

// Searches by halving, because stamps ascend with the numbers of the rows. The oldest rows are
// overwritten first, so a row that is not whole counts as too early.
StateTable::Row StateTable::findAt(Time at) const {
  std::uint64_t last = rows();  // so that no number beyond it overflows
  std::uint64_t first = oldest(last);
  Row found;
  found.tooOld = first > 1;
  while (first <= last) {
    const std::uint64_t middle = first + (last - first) / 2;
    Time stamp;
    const bool whole = stampOf(middle, stamp);
    if (!whole) found.tooOld = true;
    if (whole && stamp > at) {
      last = middle - 1;
    } else {
      if (whole) found.sequence = middle;
      first = middle + 1;
    }
  }
  return found;
}

template <class Copy>
StateTable::Row StateTable::readAt(Time at, const Copy& copy) const {
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    Row row = findAt(at);
    if (row.sequence == 0) return row;
    row.tooOld = false;
    if (tryRead(row, copy)) return row;
  }
  return overwritten();
}

auto StateTable::copying(unsigned column, std::byte* slot) const {
  return [this, column, slot](RowHeader& header, const Row& row) {
    if (row.hasValue(column)) loadColumn(column, header, slot);
  };
}

auto StateTable::copying(std::span<std::byte* const> slots) const {
  return [this, slots](RowHeader& header, const Row& row) {
    for (std::size_t i = 0; i < slots.size(); ++i) {
      if (slots[i] == nullptr || !row.hasValue(i)) continue;
      loadColumn(static_cast<unsigned>(i), header, slots[i]);
    }
  };
}

StateTable::Row StateTable::readRow(std::span<std::byte* const> slots) const {
  const auto lock = shared_.lock();
  return readNewest(copying(slots));
}

bool StateTable::readPart(const Row& row, unsigned column, std::size_t offset,
                          std::span<std::byte> to) const {
  RowHeader& header = headerAt(row.sequence);
  loadWords(to.data(), payloadOf(header) + (columns_[column].offset + offset) / 8, to.size());
  return header.sequence.load(std::memory_order_relaxed) == row.sequence;
}

StateTable::Row StateTable::readRowAt(Time at, std::span<std::byte* const> slots) const {
  const auto lock = shared_.lock();
  return readAt(at, copying(slots));
}

StateTable::Row StateTable::readRowNumber(std::uint64_t sequence,
                                          std::span<std::byte* const> slots) const {
  const auto lock = shared_.lock();
  const std::uint64_t newest = newest_->load(std::memory_order_acquire);
  Row row;
  row.sequence = sequence;
  if (sequence > newest) return Row{};
  if (sequence >= oldest(newest) && tryRead(row, copying(slots))) return row;
  return overwritten();
}

Result<Time> StateTable::read(unsigned column, std::byte* slot) const {
  const auto lock = shared_.lock();
  const Row row = readNewest(copying(column, slot));
  if (row.hasValue(column)) return row.stamp;
  return tl::unexpected(row.missing(column));
}

Result<Time> StateTable::readAt(Time at, unsigned column, std::byte* slot) const {
  const auto lock = shared_.lock();
  const Row row = readAt(at, copying(column, slot));
  if (row.hasValue(column)) return row.stamp;
  return tl::unexpected(row.missing(column));
}

}  // namespace suture::rt
