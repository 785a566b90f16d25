#pragma once
// A bounded queue of equal cells with any number of producers and one consumer.

#include <suture/base/arena.h>
#include <suture/rt/queue/record_copy.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace suture::rt {

/// Any thread may claim() and commit() (in pairs, one pair at a time a thread); one consumer thread
/// calls front() and pop(). Lock-free, no allocation after construction. A producer that is stopped
/// between claim and commit holds up the consumer at its cell, never the other producers.
///
/// A ring may also lend its cells instead of publishing them: what claim() returned is then found
/// by its place, and given back by release(), in any order.
///
/// In foreign memory the producers are of one process and the consumer of another, each process
/// with an object of its own; front() then is a copy, and whatever the other side writes harms
/// itself alone.
class MpscRing {
 public:
  /// At least `cells` cells of `cellSize` bytes each.
  MpscRing(std::size_t cells, std::size_t cellSize, Arena& arena);
  MpscRing(std::size_t cells, std::size_t cellSize, Arena&& arena = {})
      : MpscRing(cells, cellSize, arena) {}

  std::size_t cells() const { return mask_ + 1; }

  /// Producer: a cell to fill, or nullptr if all are taken.
  std::byte* claim();
  /// The same for a thread that is the only producer: without an instruction that makes it wait for
  /// its earlier stores.
  std::byte* claimAlone();
  /// Producer: publishes what claim() returned.
  void commit(std::byte* cell);

  /// Producer: the place of a cell that claim() returned.
  std::uint64_t placeOf(const std::byte* cell) const {
    return static_cast<std::uint64_t>(cell - data_.get()) / stride_;
  }
  /// Consumer: the cell lent at a place, which may be any number. In foreign memory it is copied as
  /// by front().
  template <class Copy>
  const std::byte* at(std::uint64_t place, const Copy& copy);
  /// Whoever has a lent cell gives it back.
  void release(std::uint64_t place);

  /// Consumer: true if front() has a cell to return.
  bool pending() const;
  /// Consumer: the oldest published cell, or nullptr. Stays valid until pop(). In foreign memory,
  /// `copy(to, from, size)` copies what is wanted of it.
  template <class Copy>
  const std::byte* front(const Copy& copy);
  const std::byte* front() { return front(copyAll); }
  /// Consumer: releases the cell that front() returned.
  void pop();

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

// Each cell carries the position at which it may be used next: equal to a producer's position it is
// free, one more it is published. A cell comes round again one lap (mask_ + 1) later.
//
// Inline, since most of what an event costs its sender is this, once for each subscriber.

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
      // Nobody else has claimed it, so the consumer's process has written what cannot be.
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
