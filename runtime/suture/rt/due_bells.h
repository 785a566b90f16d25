#pragma once
// The doorbells that a thread is going to ring.

#include <suture/rt/doorbell.h>
#include <suture/rt/shared_flag.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace suture::rt {

/// One thread. Rings each bell once, for all that it was added for since. No allocation; the cost
/// of add() does not grow with the number of bells.
class DueBells {
 public:
  static constexpr std::size_t kCapacity = 256;

  /// If kCapacity others are due, rings at once.
  /// `untaken`: if that is down by then, nobody is rung, since the sleeper has come upon it
  /// himself; null, or two different ones for a bell: it is rung in any case.
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
  // The index in due_ of a bell, by its hash. It holds only if that entry points back, so nothing
  // needs to be erased.
  std::array<std::uint16_t, kSlots> slots_{};
};

}  // namespace suture::rt
