#pragma once
// This is a flag in memory where another process may write any byte.

#include <atomic>
#include <cstdint>

namespace suture::rt {

/// Any thread of any process that maps it; wait-free. Unlike a std::atomic<bool>, which must hold 0
/// or 1, it is up with any byte other than 0.
class SharedFlag {
 public:
  bool isUp(std::memory_order order) const { return byte_.load(order) != 0; }
  void raise(std::memory_order order = std::memory_order_seq_cst) { byte_.store(1, order); }
  /// Raises it. The caller then also sees everything that was done before the flag was last
  /// lowered, even if it was down.
  void raiseBehindTake() { byte_.exchange(1, std::memory_order_acq_rel); }
  /// Lowers it. Returns true if it was up.
  bool take(std::memory_order order) { return byte_.exchange(0, order) != 0; }

 private:
  std::atomic<std::uint8_t> byte_{0};
  static_assert(std::atomic<std::uint8_t>::is_always_lock_free);
};

}  // namespace suture::rt
