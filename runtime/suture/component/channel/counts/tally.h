#pragma once
// This counts the outcomes of the commands of a connection.

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>

namespace suture {

/// Counts each accepted command as one of these once it has an outcome. It has none while it is
/// under way, or if it never reached the provider. Dropped events are counted here too. A frame
/// carries these eight words as they lie here.
struct Tally {
  std::uint64_t executed = 0;    ///< the handler ran to its end
  std::uint64_t late = 0;        ///< it was older than its ttl
  std::uint64_t refused = 0;     ///< suspended, parked, ending, not permitted, invalid, no room
  std::uint64_t failed = 0;      ///< the handler threw
  std::uint64_t replaced = 0;    ///< a newer one of the same latest() command came first
  std::uint64_t superseded = 0;  ///< a later command had run already
  std::uint64_t cancelled = 0;   ///< the client cancelled the command before it was executed
  std::uint64_t eventsDropped = 0;

  /// Returns how many commands have an outcome.
  std::uint64_t commands() const {
    return executed + late + refused + failed + replaced + superseded + cancelled;
  }
  friend bool operator==(const Tally&, const Tally&) = default;
};

using TallyWords = std::array<std::uint64_t, sizeof(Tally) / sizeof(std::uint64_t)>;

/// Returns a tally whose every count is `combine(a, b)` of the same count of the two.
template <class Combine>
Tally combined(const Tally& one, const Tally& other, const Combine& combine) {
  auto words = std::bit_cast<TallyWords>(one);
  const auto others = std::bit_cast<TallyWords>(other);
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = combine(words[i], others[i]);
  return std::bit_cast<Tally>(words);
}

inline Tally operator+(const Tally& one, const Tally& other) {
  return combined(one, other, [](std::uint64_t a, std::uint64_t b) { return a + b; });
}
/// No count falls below zero, because the two may have been read at different moments.
inline Tally operator-(const Tally& one, const Tally& other) {
  return combined(one, other, [](std::uint64_t a, std::uint64_t b) { return a - (a < b ? a : b); });
}

/// One thread writes this tally, and any thread may read it.
class SharedTally {
 public:
  void store(const Tally& tally) {
    const auto words = std::bit_cast<TallyWords>(tally);
    for (std::size_t i = 0; i < words.size(); ++i) {
      words_[i].store(words[i], std::memory_order_relaxed);
    }
  }
  Tally load() const {
    TallyWords words;
    for (std::size_t i = 0; i < words.size(); ++i) {
      words[i] = words_[i].load(std::memory_order_relaxed);
    }
    return std::bit_cast<Tally>(words);
  }

 private:
  std::array<std::atomic<std::uint64_t>, std::tuple_size_v<TallyWords>> words_{};
};

}  // namespace suture
