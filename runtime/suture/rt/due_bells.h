#pragma once
// This collects the doorbells that a thread is going to ring.

#include <suture/rt/doorbell.h>
#include <suture/rt/shared_flag.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace suture::rt {

/// One thread. Rings each bell once, for everything that it was added for since the last time.
/// Never allocates, and the cost of add() does not grow with the number of bells.
class DueBells {
 public:
  static constexpr std::size_t kCapacity = 256;

  /// Adds a bell; if kCapacity others are due, rings it at once. `untaken` is a flag that the
  /// sleeper lowers when it takes what the bell was added for: if it is down by then, the bell is
  /// not rung. If it is null, or a bell was added with two different flags, the bell is rung in any
  /// case.
  void add(Doorbell& bell, RungFor what = RungFor::Work, SharedFlag* untaken = nullptr);
  void ringAll();

 private:
  static constexpr unsigned kSlotBits = 9;
  static constexpr std::size_t kSlots = std::size_t{1} << kSlotBits;
  static_assert(kSlots >= 2 * kCapacity, "a free slot must be near");

  struct Due {
    Doorbell* bell;
    std::uint32_t slot;
    RungFor what;
    SharedFlag* untaken;
  };

  static std::size_t firstSlot(const Doorbell& bell);

  std::size_t count_ = 0;
  std::array<Due, kCapacity> due_{};
  // Holds the index in due_ of a bell, by its hash. An entry counts only if due_ points back to it,
  // so that nothing needs to be erased.
  std::array<std::uint16_t, kSlots> slots_{};
};

}  // namespace suture::rt
