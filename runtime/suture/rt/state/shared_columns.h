#pragma once
// These are the columns of a state table that hold counted pointers.

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace suture {
class SharedSlot;
}

namespace suture::rt {

/// Holds the newest value of each column in `which` (base/slots/shared_slot.h). Only tables of
/// devices have such columns. Everything here is used under lock().
class SharedColumns {
 public:
  SharedColumns(std::uint64_t which, std::size_t columns);
  ~SharedColumns();
  SharedColumns(const SharedColumns&) = delete;
  SharedColumns& operator=(const SharedColumns&) = delete;

  std::uint64_t which() const { return which_; }
  bool contains(unsigned column) const { return (which_ >> column & 1) != 0; }
  /// Takes the lock; returns a lock of nothing if there are no such columns.
  std::unique_lock<std::mutex> lock() const {
    return which_ == 0 ? std::unique_lock<std::mutex>() : std::unique_lock(mutex_);
  }

  /// Moves what `draft` holds into the column; if it holds nothing, the column keeps its value.
  void take(unsigned column, std::byte* draft);
  /// Puts one more pointer to the column's value into `slot`, and releases what the slot held.
  void copy(unsigned column, std::byte* slot) const;

 private:
  const std::uint64_t which_;
  mutable std::mutex mutex_;
  std::vector<SharedSlot*> newest_;  // by column
};

}  // namespace suture::rt
