#pragma once
// This holds what is under way in one direction.

#include <suture/base/time.h>
#include <suture/base/words.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace suture {

/// One thread; no allocation after construction. Holds records, each due at a time.
class DelayLine {
 public:
  enum class Order : std::uint8_t {
    Kept,         ///< due no sooner than any before it
    Overtakable,  ///< due at its own time, and what follows at theirs
  };

  /// Makes room for `records` of `largest` bytes each, but for at most 16 MiB of them, and for at
  /// least four.
  DelayLine(std::size_t largest, std::size_t records);

  /// Returns true if that many more have room.
  bool hasRoom(std::size_t records) const { return free_.size() >= records; }
  /// Returns memory for a record that is due at `due`, to be filled before commit(); nullptr: no
  /// room. A record that is not committed before the next claim() is dropped.
  std::byte* claim(Time due, std::size_t size, Order order = Order::Kept);
  void commit();
  /// Returns when the last one claimed is due, including what it waits behind.
  Time claimedDue() const { return claimed_.due; }

  /// Returns the record that is due first if it is due at `now`, else nullptr. It stays until
  /// pop(), which must come before the next commit().
  const std::byte* due(Time now) const;
  std::size_t size() const { return waiting_.front().size; }
  void pop();

  /// Returns when the first record is due; Time::max() if there is none.
  Time next() const { return waiting_.empty() ? Time::max() : waiting_.front().due; }

 private:
  struct Record {
    Time due;
    std::uint64_t number;  // orders records that are due at the same time
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
