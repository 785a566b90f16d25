#pragma once
// What a connection is expected to keep to, and what happens when it does not: docs/safety.md.

#include <suture/base/time.h>

#include <atomic>
#include <cstdint>

namespace suture {

/// What a read answers when its value is too old, or its provider lost. Its sample carries the
/// Errc in any case.
enum class Fallback : std::uint8_t {
  Hold,   ///< no value to act on; the last one comes along to be looked at
  Zero,   ///< all numbers 0, all that has a size empty, to be acted on; a rotation is none then
  Last,   ///< the last value, to be acted on
  Fault,  ///< as Hold, and the reading component is parked
};

/// After a loss or a stale read, this lets commands through again.
enum class Resume : std::uint8_t { Automatic, Operator };

/// A value; 0 in a duration: no such limit, unless it says otherwise.
struct ConnectionContract {
  static constexpr Duration kDefaultSilence = std::chrono::seconds(2);
  static constexpr Duration kShortestSilence = std::chrono::milliseconds(10);

  Duration maxAge{0};    ///< of what reads answer
  Duration deadline{0};  ///< of calls: what within() waits, in place of what the commands state
  Fallback onStale = Fallback::Hold;
  Fallback onLoss = Fallback::Hold;
  Resume resume = Resume::Automatic;
  /// How long another process may say nothing, or the provider's task hang, before it counts as
  /// lost; 0: kDefaultSilence.
  Duration silence{0};

  Duration longestSilence() const { return silence == Duration{0} ? kDefaultSilence : silence; }

  bool operator==(const ConnectionContract&) const = default;
};

/// The contract of one connection and how it has been kept: what lives on when a lost connection
/// gets a new channel.
struct ConnectionWatch {
  explicit ConnectionWatch(const ConnectionContract& agreed) : contract(agreed) {}

  const ConnectionContract contract;
  /// Set by the client's thread, cleared by the operator's: commands are refused meanwhile.
  std::atomic<bool> awaitsOperator{false};
  std::atomic<std::uint64_t> staleReads{0}, losses{0};  ///< written by the client's thread
};

}  // namespace suture
