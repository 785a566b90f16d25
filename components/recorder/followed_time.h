#pragma once
// This sums up for how much of a run a slave followed.

#include <suture/base/time.h>

#include <optional>
#include <vector>

#include "recorder/recording.h"

namespace robots {

/// A Span is a part of a run, from its begin until its end.
struct Span {
  suture::Time begin, end;
};

/// Says in which part of a run a slave had to follow.
struct Duty {
  /// The run ended at this time; without it, the recordings say when.
  std::optional<suture::Time> end = {};
  /// It need not follow in these parts, in any order. Each is longer by what the slave then needs
  /// until it follows again, but by no more than three seconds.
  std::vector<Span> excused = {};
};

/// Returns when the clutch was pressed, as parts of a run that ended at `end`. A release of a
/// moment is none: the teleoperation had no data then.
std::vector<Span> clutched(const std::vector<ClutchNews>& news, suture::Time end);

struct FollowedShare {
  double share = 0;  ///< the followed part of the time in which it had to, since it first did
  /// The longest part in which it did not follow began and ended here, in s since it first did.
  double missing_from = 0, missing_until = 0;
};

/// Hears of a slave's cycles one after the other.
class FollowedTime {
 public:
  /// Tells of a cycle, by ascending stamp. What nobody recorded for 50 ms was not followed.
  void add(suture::Time stamp, bool follows);
  FollowedShare until(suture::Time end, const std::vector<Span>& excused) const;

 private:
  std::optional<suture::Time> first_;
  suture::Time last_;
  std::vector<Span> missing_;  // when it did not follow
};

}  // namespace robots
