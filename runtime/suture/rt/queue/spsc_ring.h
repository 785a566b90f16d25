#pragma once
// This is a bounded queue of variable-length records between exactly one producer and one consumer,
// written and read in place.

#include <suture/base/arena.h>
#include <suture/base/words.h>
#include <suture/rt/queue/record_copy.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace suture::rt {

/// One producer thread calls claim() and commit(), one consumer thread calls front() and pop().
/// Wait-free; never allocates after construction. Records are aligned to 8 bytes and never wrap
/// around the end.
///
/// In foreign memory each process has an object of its own and uses one end. It reads each number
/// that the other may have written once, and checks it; front() then is a copy. A ring whose
/// numbers cannot be right stays empty for ever.
class SpscRing {
 public:
  /// Makes room for at least `bytes` of records, each counted as recordSize(its size). `largest` is
  /// the size of the largest record that claim() is asked for.
  SpscRing(std::size_t bytes, std::size_t largest, Arena& arena);
  SpscRing(std::size_t bytes, std::size_t largest, Arena&& arena = {})
      : SpscRing(bytes, largest, arena) {}

  /// Returns how many bytes a record of `size` bytes takes up in the ring.
  static constexpr std::size_t recordSize(std::size_t size) {
    return sizeof(std::uint64_t) + wordBytes(size);
  }

  /// The producer. Returns memory for a record, or nullptr if there is no room. The record is
  /// invisible until commit().
  std::byte* claim(std::size_t size);
  /// The producer. Publishes the record of the last claim().
  void commit() {
    tail_ = claimedTail_;
    shared_->tail.store(tail_, std::memory_order_release);
  }

  /// The consumer. Returns the oldest record, or nullptr. It stays valid until pop(). In foreign
  /// memory, `copy(to, from, size)` copies the wanted part of it.
  template <class Copy>
  const std::byte* front(const Copy& copy);
  const std::byte* front() { return front(copyAll); }
  /// The consumer. Returns the size of the record that front() returned.
  std::size_t frontSize() const;
  /// The consumer. Releases the record that front() returned.
  void pop();

 private:
  // A header word holds the size of the record behind it; this value says that the rest of the lap
  // is unused.
  static constexpr std::uint64_t kSkip = ~std::uint64_t{0};

  // Positions count bytes and never wrap; the index is the position modulo the size.
  struct Shared {
    alignas(64) std::atomic<std::uint64_t> tail{0};
    alignas(64) std::atomic<std::uint64_t> head{0};
  };

  std::uint64_t& headerAt(std::uint64_t position) const {
    return *reinterpret_cast<std::uint64_t*>(data_.get() + (position & mask_));
  }
  std::size_t untilEnd(std::uint64_t position) const { return mask_ + 1 - (position & mask_); }
  const std::byte* oldest();
  const std::byte* oldestForeign();

  std::size_t mask_;
  std::shared_ptr<Shared> shared_;
  std::shared_ptr<std::byte> data_;
  // Each side keeps its own position, and a copy of the other's last known one, so that the shared
  // lines move only when a side runs out.
  alignas(64) std::uint64_t tail_ = 0;
  std::uint64_t claimedTail_ = 0;
  std::uint64_t knownHead_ = 0;
  alignas(64) std::uint64_t head_ = 0;
  std::uint64_t knownTail_ = 0;
  // Holds the front record, which the consumer has copied out of foreign memory.
  std::vector<std::byte> copy_;
  std::size_t copySize_ = 0;
  bool copied_ = false;
  bool broken_ = false;
};

template <class Copy>
const std::byte* SpscRing::front(const Copy& copy) {
  if (copied_) return copy_.data();
  const std::byte* const record = oldest();
  if (record == nullptr || copy_.empty()) return record;
  copy(copy_.data(), record, copySize_);
  copied_ = true;
  return copy_.data();
}

}  // namespace suture::rt
