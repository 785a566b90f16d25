#pragma once
// How the steady clock of a peer stands to this process's.

#include <suture/base/time.h>

namespace suture {

/// Learns from questions with stamps around them, as NTP does (RFC 5905): the one with the smallest
/// error counts, unless a later one shows that it cannot be so. A value.
class ClockOffset {
 public:
  /// Both have one clock: nothing has to be measured.
  static ClockOffset none() {
    ClockOffset one;
    one.one_ = true;
    one.error_ = Duration{0};
    return one;
  }
  /// An offset that is not known yet.
  ClockOffset() = default;

  /// True if both have one clock.
  bool isOne() const { return one_; }

  /// `asked` and `answered` are on this process's clock, `received` and `sent` on the peer's, in
  /// ns. True if that tells more than what was known by then.
  bool add(Time asked, std::int64_t received, std::int64_t sent, Time answered);

  /// The peer's clock minus ours.
  Duration offset() const { return offset_; }
  /// How wrong that may be at `present`, either way: half of the time for which the question was
  /// under way, and what the clocks may have drifted apart since.
  Duration error(Time present) const;

 private:
  bool contradicts(Duration offset, Duration errors) const;

  bool one_ = false;
  Duration offset_{0};
  Duration error_ = Duration::max();  // when it was compared
  Time compared_{};
};

}  // namespace suture
