#pragma once
// What is under way in one direction.

#include <suture/base/time.h>
#include <suture/rt/spsc_ring.h>

#include <cstddef>

namespace suture {

/// Records in the order in which they came, each due at a time. One thread. No allocation after
/// construction.
class DelayLine {
 public:
  /// Room for at least `records` of `largest` bytes each, but not for more than 16 MiB of them, and
  /// for four at least.
  DelayLine(std::size_t largest, std::size_t records);

  /// Memory for a record that is due at `due`, to be filled before commit(); nullptr: no room.
  std::byte* claim(Time due, std::size_t size);
  void commit() { ring_.commit(); }

  /// The oldest record if it is due at `now`, else nullptr. Stays until pop().
  const std::byte* due(Time now);
  std::size_t size() const { return ring_.frontSize() - sizeof(Time); }
  void pop() { ring_.pop(); }

  /// When the oldest record is due; Time::max() if there is none.
  Time next();

 private:
  rt::SpscRing ring_;
  Time last_{};
};

}  // namespace suture
