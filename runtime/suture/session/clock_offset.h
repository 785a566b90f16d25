#pragma once
// This estimates how far the steady clock of a peer is from this process's.

#include <suture/base/time.h>

namespace suture {

/// A ClockOffset is a value. It learns from questions with stamps around them, as NTP does (RFC
/// 5905): the one with the smallest error counts, unless a later one contradicts it.
class ClockOffset {
 public:
  /// Returns the offset of two processes with one clock, where nothing has to be measured.
  static ClockOffset none() {
    ClockOffset one;
    one.one_ = true;
    one.error_ = Duration{0};
    return one;
  }
  /// Makes an offset that is not known yet.
  ClockOffset() = default;

  /// Returns true if both have one clock.
  bool isOne() const { return one_; }

  /// `asked` and `answered` are on this process's clock, `received` and `sent` on the peer's, in
  /// ns. Returns true if that tells more than was known before.
  bool add(Time asked, std::int64_t received, std::int64_t sent, Time answered);

  /// Returns the peer's clock minus ours.
  Duration offset() const { return offset_; }
  /// Returns how wrong the offset may be at `present`, either way: half of the time for which the
  /// question was under way, and what the clocks may have drifted apart since.
  Duration error(Time present) const;

 private:
  bool contradicts(Duration offset, Duration errors) const;

  bool one_ = false;
  Duration offset_{0};
  Duration error_ = Duration::max();  // at the time of comparison
  Time compared_{};
};

}  // namespace suture
