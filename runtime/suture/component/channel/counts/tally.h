#pragma once
// What has become of the commands of a connection.

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>

namespace suture {

/// Each command that was accepted from a client ends as one of these, or as none of them: while it
/// is under way, or if it never reached the provider. Beside them the events that were dropped.
/// Eight words, as they travel in a frame.
struct Tally {
  std::uint64_t executed = 0;    ///< the handler ran to its end
  std::uint64_t late = 0;        ///< older than its ttl
  std::uint64_t refused = 0;     ///< turned away: suspended, parked, ending, not permitted, invalid
  std::uint64_t failed = 0;      ///< the handler threw
  std::uint64_t replaced = 0;    ///< a newer one of the same latest() command came first
  std::uint64_t superseded = 0;  ///< a later command had run already
  std::uint64_t cancelled = 0;   ///< by its client, before it was executed
  std::uint64_t eventsDropped = 0;

  /// How many commands have an outcome.
  std::uint64_t commands() const {
    return executed + late + refused + failed + replaced + superseded + cancelled;
  }
  friend bool operator==(const Tally&, const Tally&) = default;
};

using TallyWords = std::array<std::uint64_t, sizeof(Tally) / sizeof(std::uint64_t)>;

/// `combine(a, b)` of each count of the two.
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
/// No count falls below zero: the two may have been read at different moments.
inline Tally operator-(const Tally& one, const Tally& other) {
  return combined(one, other, [](std::uint64_t a, std::uint64_t b) { return a - (a < b ? a : b); });
}

/// A tally that one thread writes and any reads.
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
