#pragma once
// A flag in memory that another process may write, whatever it writes there.

#include <atomic>
#include <cstdint>

namespace suture::rt {

/// Any thread of any process that maps it; wait-free. Unlike a std::atomic<bool>, in which only 0
/// and 1 may stand, it is up with any byte but 0.
class SharedFlag {
 public:
  bool isUp(std::memory_order order) const { return byte_.load(order) != 0; }
  void raise(std::memory_order order = std::memory_order_seq_cst) { byte_.store(1, order); }
  /// Raises it, and sees from here on what was done before it was lowered last, even if it was
  /// down.
  void raiseBehindTake() { byte_.exchange(1, std::memory_order_acq_rel); }
  /// Lowers it. True if it was up.
  bool take(std::memory_order order) { return byte_.exchange(0, order) != 0; }

 private:
  std::atomic<std::uint8_t> byte_{0};
  static_assert(std::atomic<std::uint8_t>::is_always_lock_free);
};

}  // namespace suture::rt
