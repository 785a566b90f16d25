#pragma once
// These say how long the stress lasts and where its threads run.

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace stress {

/// Lasts until a time is over: a tenth of a second, or as many seconds as SUTURE_STRESS_SECONDS
/// says.
class Span {
 public:
  Span();
  /// It is never over before one thing is done: a thread may get no turn in all this time.
  bool over(std::uint64_t done) const;

 private:
  std::int64_t end_;
};

/// Runs each of `bodies` in a thread of its own, pinned to one processor after the other of those
/// that the process may use, and returns when all have.
void runAcrossProcessors(const std::vector<std::function<void()>>& bodies);

constexpr std::uint64_t kProducers = 3;

/// Returns bodies of kProducers threads that each call `send(producer, serial)` until `span` is
/// over, with the same serial number again where it returns false at a full queue. `sent` gets how
/// many each could send, `ended` how many have ended.
std::vector<std::function<void()>> producers(
    const Span& span, std::vector<std::uint64_t>& sent, std::atomic<std::uint64_t>& ended,
    const std::function<bool(std::uint64_t, std::uint64_t)>& send);

/// Returns a serial number that tells which producer sent it.
inline std::uint64_t tagged(std::uint64_t producer, std::uint64_t serial) {
  return serial * kProducers + producer;
}

/// Counts what must not be, of one consumer.
struct Faults {
  std::uint64_t torn = 0, backwards = 0, seen = 0;

  /// Returns the serial number of what was received; it must be greater than any before.
  std::uint64_t take(std::uint64_t serial);
  /// Tells if it is of no use to go on: what is broken may never come to an end.
  bool hopeless() const { return torn + backwards > 100; }

 private:
  std::uint64_t last_ = 0;
};

/// Reports `faults` of `what` to gtest, and that anything was seen at all.
void expectNone(const Faults& faults, const std::string& what);

}  // namespace stress
