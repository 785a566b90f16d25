#pragma once
// This says what a connection is expected to keep to, and what happens when it does not:
// docs/safety.md.

#include <suture/base/time.h>

#include <atomic>
#include <cstdint>

namespace suture {

/// Says what a read answers if its value is too old, or its provider is lost. Its sample carries
/// the Errc in any case.
enum class Fallback : std::uint8_t {
  Hold,   ///< no value to act on; the last one comes along to be looked at
  Zero,   ///< all numbers 0 and all lists empty, to be acted on; a rotation is invalid then
  Last,   ///< the last value, to be acted on
  Fault,  ///< as Hold, and the reading component is parked
};

/// Says who admits commands again after a loss or a stale read.
enum class Resume : std::uint8_t { Automatic, Operator };

/// Any thread may have its own copy. A duration of 0 means no limit, unless its comment says
/// otherwise.
struct ConnectionContract {
  static constexpr Duration kDefaultSilence = std::chrono::seconds(2);
  static constexpr Duration kShortestSilence = std::chrono::milliseconds(10);

  Duration maxAge{0};    ///< limits the age of what reads answer
  Duration deadline{0};  ///< limits how long within() waits, in place of what the commands state
  Fallback onStale = Fallback::Hold;
  Fallback onLoss = Fallback::Hold;
  Resume resume = Resume::Automatic;
  /// Says how long another process may say nothing, or the provider's task hang, before it counts
  /// as lost; 0: kDefaultSilence.
  Duration silence{0};

  Duration longestSilence() const { return silence == Duration{0} ? kDefaultSilence : silence; }

  bool operator==(const ConnectionContract&) const = default;
};

/// Holds the contract of one connection, and says how it has been kept. It lives on when a lost
/// connection gets a new channel.
struct ConnectionWatch {
  explicit ConnectionWatch(const ConnectionContract& agreed) : contract(agreed) {}

  const ConnectionContract contract;
  /// The client's thread sets this, and the thread that resumes the connection clears it. Commands
  /// are refused meanwhile.
  std::atomic<bool> awaitsOperator{false};
  std::atomic<std::uint64_t> staleReads{0}, losses{0};  ///< written by the client's thread
};

}  // namespace suture
