#pragma once
// This is a bounded queue of equal cells with any number of producers and one consumer.

#include <suture/base/arena.h>
#include <suture/rt/queue/record_copy.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace suture::rt {

/// Any thread may call claim() and commit() (in pairs, one pair at a time in each thread); one
/// consumer thread calls front() and pop(). Lock-free; never allocates after construction. A
/// producer that is stopped between claim() and commit() holds up the consumer at its cell, but
/// never the other producers.
///
/// A ring may also lend its cells instead of publishing them: a claimed cell is then found by its
/// place, and given back by release(), in any order.
///
/// In foreign memory the producers are in one process and the consumer in another, each process
/// with an object of its own. front() then is a copy, and whatever the other side writes harms only
/// itself.
class MpscRing {
 public:
  /// Makes at least `cells` cells of `cellSize` bytes each.
  MpscRing(std::size_t cells, std::size_t cellSize, Arena& arena);
  MpscRing(std::size_t cells, std::size_t cellSize, Arena&& arena = {})
      : MpscRing(cells, cellSize, arena) {}

  std::size_t cells() const { return mask_ + 1; }

  /// A producer. Returns a cell to fill, or nullptr if all are taken.
  std::byte* claim();
  /// The only producer. Does the same as claim(), without an instruction that makes the thread wait
  /// for its earlier stores.
  std::byte* claimAlone();
  /// A producer. Publishes what claim() returned.
  void commit(std::byte* cell);

  /// A producer. Returns the place of a cell that claim() returned.
  std::uint64_t placeOf(const std::byte* cell) const {
    return static_cast<std::uint64_t>(cell - data_.get()) / stride_;
  }
  /// The consumer. Returns the cell that was lent at `place`, which may be any number. In foreign
  /// memory it is copied as by front().
  template <class Copy>
  const std::byte* at(std::uint64_t place, const Copy& copy);
  /// The thread that has a lent cell gives it back.
  void release(std::uint64_t place);

  /// The consumer. Returns true if front() has a cell to return.
  bool pending() const;
  /// The consumer. Returns the oldest published cell, or nullptr. It stays valid until pop(). In
  /// foreign memory, `copy(to, from, size)` copies the wanted part of it.
  template <class Copy>
  const std::byte* front(const Copy& copy);
  const std::byte* front() { return front(copyAll); }
  /// The consumer. Releases the cell that front() returned.
  void pop();
  /// The consumer. Returns the position of front(); the first was at 0.
  std::uint64_t position() const { return head_; }
  /// The consumer. Returns the position behind the last cell that front() could return by now.
  std::uint64_t end() const;

 private:
  const std::byte* oldest() const { return pending() ? cellAt(head_) : nullptr; }
  std::byte* cellAt(std::uint64_t position) const {
    return reinterpret_cast<std::byte*>(&sequenceAt(position)) + sizeof(std::uint64_t);
  }
  std::atomic<std::uint64_t>& sequenceAt(std::uint64_t position) const {
    return *reinterpret_cast<std::atomic<std::uint64_t>*>(data_.get() +
                                                          (position & mask_) * stride_);
  }

  std::size_t mask_;
  std::size_t stride_;
  std::shared_ptr<std::byte> data_;
  alignas(64) std::atomic<std::uint64_t> tail_{0};
  alignas(64) std::uint64_t head_ = 0;
  std::vector<std::byte> copy_;  // in foreign memory: the front cell's
  bool copied_ = false;
};

template <class Copy>
const std::byte* MpscRing::at(std::uint64_t place, const Copy& copy) {
  const std::byte* const cell = cellAt(place);
  if (copy_.empty()) return cell;
  copy(copy_.data(), cell, copy_.size());
  return copy_.data();
}

template <class Copy>
const std::byte* MpscRing::front(const Copy& copy) {
  if (copied_) return copy_.data();
  const std::byte* const cell = oldest();
  if (cell == nullptr || copy_.empty()) return cell;
  copy(copy_.data(), cell, copy_.size());
  copied_ = true;
  return copy_.data();
}

// Each cell holds a number that says at which position it may be used next: if it equals a
// producer's position, the cell is free; if it is one more, the cell is published. A cell is used
// again one lap (mask_ + 1 positions) later.
//
// These functions are inline because they, once for each subscriber, are most of what an event
// costs its sender.

inline std::byte* MpscRing::claim() {
  std::uint64_t position = tail_.load(std::memory_order_relaxed);
  while (true) {
    const std::uint64_t sequence = sequenceAt(position).load(std::memory_order_acquire);
    if (sequence == position) {
      if (tail_.compare_exchange_weak(position, position + 1, std::memory_order_relaxed)) {
        return cellAt(position);
      }
    } else if (sequence < position) {
      return nullptr;
    } else {
      const std::uint64_t next = tail_.load(std::memory_order_relaxed);
      // No other producer has claimed it, so the consumer's process has written an impossible
      // number.
      if (next == position) return nullptr;
      position = next;
    }
  }
}

inline std::byte* MpscRing::claimAlone() {
  const std::uint64_t position = tail_.load(std::memory_order_relaxed);
  auto& sequence = sequenceAt(position);
  if (sequence.load(std::memory_order_acquire) != position) return nullptr;
  tail_.store(position + 1, std::memory_order_relaxed);
  return reinterpret_cast<std::byte*>(&sequence) + sizeof(std::uint64_t);
}

inline void MpscRing::commit(std::byte* cell) {
  auto& sequence = *reinterpret_cast<std::atomic<std::uint64_t>*>(cell - sizeof(std::uint64_t));
  sequence.store(sequence.load(std::memory_order_relaxed) + 1, std::memory_order_release);
}

}  // namespace suture::rt
