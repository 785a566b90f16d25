#include <suture/base/shared_slot.h>
#include <suture/rt/state_table.h>

#include <bit>
#include <cstring>
#include <new>
#include <utility>

namespace suture::rt {
namespace {

constexpr std::size_t wordsFor(std::size_t bytes) { return (bytes + 7) / 8; }

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

std::size_t payloadBytes(std::span<const std::uint32_t> columnSizes) {
  std::size_t bytes = 0;
  for (const std::uint32_t size : columnSizes) bytes += 8 * wordsFor(size);
  return bytes;
}

}  // namespace

StateTable::StateTable(std::span<const std::uint32_t> columnSizes, unsigned rows, ColumnSet shared)
    : rowBytes_((sizeof(RowHeader) + payloadBytes(columnSizes) + 63) & ~std::size_t{63}),
      rowMask_(std::bit_ceil(rows) - 1),
      draft_(payloadBytes(columnSizes)),
      shared_(shared),
      newestShared_(columnSizes.size(), nullptr),
      memory_("suture-state", rowBytes_ * (rowMask_ + 1)) {
  std::uint32_t offset = 0;
  for (const std::uint32_t size : columnSizes) {
    columns_.push_back({offset, size});
    offset += static_cast<std::uint32_t>(8 * wordsFor(size));
  }
  for (std::size_t i = 0; i <= rowMask_; ++i) new (memory_.data() + i * rowBytes_) RowHeader{};
}

StateTable::~StateTable() {
  for (unsigned i = 0; i < columns_.size(); ++i) {
    if (!isShared(i)) continue;
    draft(i);
    if (newestShared_[i] != nullptr) newestShared_[i]->release();
  }
}

std::byte* StateTable::draft(unsigned column) {
  std::byte* const memory = draft_.data() + columns_[column].offset;
  if (isShared(column)) releaseSharedSlot(memory);  // of a row that was not published
  return memory;
}

void StateTable::publishShared(ColumnSet valid) {
  const std::lock_guard lock(newestSharedMutex_);
  for (unsigned i = 0; i < columns_.size(); ++i) {
    std::byte* const memory = draft_.data() + columns_[i].offset;
    const bool stays = !isShared(i) || (valid >> i & 1) == 0 || sharedSlotIn(memory) == nullptr;
    if (stays) continue;
    SharedSlot* const old = std::exchange(newestShared_[i], sharedSlotIn(memory));
    putSharedSlot(memory, nullptr);
    if (old != nullptr) old->release();
  }
}

void StateTable::loadColumn(unsigned column, RowHeader& header, std::byte* slot) const {
  if (!isShared(column)) {
    const Column& wanted = columns_[column];
    loadWords(slot, payloadOf(header) + wanted.offset / 8, wanted.size);
    return;
  }
  const std::lock_guard lock(newestSharedMutex_);
  releaseSharedSlot(slot);
  newestShared_[column]->retain();
  putSharedSlot(slot, newestShared_[column]);
}

StateTable::RowHeader& StateTable::headerAt(std::uint64_t sequence) const {
  return *reinterpret_cast<RowHeader*>(memory_.data() + (sequence & rowMask_) * rowBytes_);
}

void StateTable::publish(Time stamp, ColumnSet valid, ColumnSet tooLarge) {
  if ((valid & shared_) != 0) publishShared(valid);
  const std::uint64_t sequence = newest_.load(std::memory_order_relaxed) + 1;
  RowHeader& header = headerAt(sequence);
  header.sequence.store(0, std::memory_order_relaxed);
  header.stamp.store(static_cast<std::uint64_t>(toNanoseconds(stamp)), std::memory_order_release);
  header.valid.store(valid, std::memory_order_release);
  header.tooLarge.store(tooLarge, std::memory_order_release);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if ((valid & ~shared_) >> i & 1) {
      storeWords(payloadOf(header) + columns_[i].offset / 8, draft_.data() + columns_[i].offset,
                 columns_[i].size);
    }
  }
  header.sequence.store(sequence, std::memory_order_release);
  newest_.store(sequence, std::memory_order_release);
}

bool StateTable::ask(unsigned column) {
  const ColumnSet bit = ColumnSet{1} << column;
  if ((demand_.load(std::memory_order_relaxed) & bit) != 0) return false;
  return (demand_.fetch_or(bit, std::memory_order_acq_rel) & bit) == 0;
}

// Runs `copy(header, row)` on the newest complete row and tells whether the row stayed whole
// meanwhile.
template <class Copy>
bool StateTable::tryReadNewest(Row& row, const Copy& copy) const {
  row = Row{};
  const std::uint64_t sequence = newest_.load(std::memory_order_acquire);
  if (sequence == 0) return true;
  RowHeader& header = headerAt(sequence);
  if (header.sequence.load(std::memory_order_acquire) != sequence) return false;
  row.sequence = sequence;
  row.stamp =
      fromNanoseconds(static_cast<std::int64_t>(header.stamp.load(std::memory_order_acquire)));
  row.valid = header.valid.load(std::memory_order_acquire);
  row.tooLarge = header.tooLarge.load(std::memory_order_acquire);
  copy(header, row);
  return header.sequence.load(std::memory_order_relaxed) == sequence;
}

// A reader fails only if the writer went nearly a whole lap while it copied; each retry starts
// afresh.
template <class Copy>
StateTable::Row StateTable::readNewest(const Copy& copy) const {
  Row row;
  for (int attempt = 0; attempt < 100; ++attempt) {
    if (tryReadNewest(row, copy)) return row;
  }
  return Row{};
}

StateTable::Row StateTable::readRow(std::span<std::byte* const> slots) const {
  return readNewest([&](RowHeader& header, const Row& row) {
    for (std::size_t i = 0; i < slots.size(); ++i) {
      if (slots[i] == nullptr || (row.valid >> i & 1) == 0) continue;
      loadColumn(static_cast<unsigned>(i), header, slots[i]);
    }
  });
}

Result<Time> StateTable::read(unsigned column, std::byte* slot) const {
  const Row row = readNewest([&](RowHeader& header, const Row& newest) {
    if (newest.valid >> column & 1) loadColumn(column, header, slot);
  });
  if (row.valid >> column & 1) return row.stamp;
  return tl::unexpected(row.tooLarge >> column & 1 ? Errc::TooLarge : Errc::NotYet);
}

}  // namespace suture::rt
