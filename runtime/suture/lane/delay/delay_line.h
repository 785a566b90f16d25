#pragma once
// What is under way in one direction.

#include <suture/base/time.h>
#include <suture/base/words.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace suture {

/// Records, each due at a time. One thread. No allocation after construction.
class DelayLine {
 public:
  enum class Order : std::uint8_t {
    Kept,         ///< due no sooner than any before it
    Overtakable,  ///< due at its own time, and what follows at theirs
  };

  /// Room for `records` of `largest` bytes each, but not for more than 16 MiB of them, and for four
  /// at least.
  DelayLine(std::size_t largest, std::size_t records);

  /// True if so many more have room.
  bool hasRoom(std::size_t records) const { return free_.size() >= records; }
  /// Memory for a record that is due at `due`, to be filled before commit(); nullptr: no room. What
  /// has not been committed by the next claim() is given up.
  std::byte* claim(Time due, std::size_t size, Order order = Order::Kept);
  void commit();
  /// When the last one claimed is due, with what it waits behind.
  Time claimedDue() const { return claimed_.due; }

  /// The record that is due first if it is so at `now`, else nullptr. Stays until pop(), which is
  /// to come before the next commit().
  const std::byte* due(Time now) const;
  std::size_t size() const { return waiting_.front().size; }
  void pop();

  /// When the first record is due; Time::max() if there is none.
  Time next() const { return waiting_.empty() ? Time::max() : waiting_.front().due; }

 private:
  struct Record {
    Time due;
    std::uint64_t number;  // of records due at one time, the first claimed comes first
    std::size_t size;
    std::uint32_t slot;
  };

  static bool isLater(const Record& one, const Record& other);
  std::byte* memoryOf(std::uint32_t slot) const { return memory_.get() + slot * slotSize_; }

  const std::size_t slotSize_;
  const std::unique_ptr<std::byte[]> memory_;
  std::vector<std::uint32_t> free_;
  std::vector<Record> waiting_;  // a heap: the first that is due in front
  Record claimed_{};
  Order claimedOrder_ = Order::Kept;
  std::uint64_t numbered_ = 0;
  Time last_{};
};

}  // namespace suture
