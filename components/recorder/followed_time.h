#pragma once
// This sums up for how much of a run a slave followed.

#include <suture/base/time.h>

#include <optional>
#include <vector>

#include "recorder/recording.h"

namespace robots {

/// Is a part of a run, from its begin until its end.
struct Span {
  suture::Time begin, end;
};

/// Says in which part of a run a slave had to follow.
struct Duty {
  /// Is when the run ended; if there is none, the recordings say so.
  std::optional<suture::Time> end = {};
  /// Are the parts in which it need not follow, in any order. Each is longer by what the slave then
  /// needs until it follows again, but by no more than three seconds.
  std::vector<Span> excused = {};
};

/// Returns when the clutch was pressed, as parts of a run that ended at `end`.
std::vector<Span> clutched(const std::vector<ClutchNews>& news, suture::Time end);

struct FollowedShare {
  double share = 0;  ///< of the time in which it had to follow, since it first did
  /// Are when the longest part in which it did not follow began and ended, in s since it first did.
  double missing_from = 0, missing_until = 0;
};

/// Is told of a slave's cycles one after the other.
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
