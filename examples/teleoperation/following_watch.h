#pragma once
// This judges the slaves while they are recorded.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "recorder/judge.h"
#include "recorder/recording.h"
#include "run/plan.h"
#include "slave_watch.h"

namespace demo {

/// One thread. Judges one slave that follows one master.
class FollowingWatch {
 public:
  explicit FollowingWatch(const Following& following);

  const Following& following() const { return following_; }
  /// Returns how far off the slave was since the last call, by what has been recorded until now;
  /// none if there is nothing to compare. Throws suture::SetupError if a recording cannot be read.
  std::optional<robots::ErrorSummary> recent();
  /// Reads the rest, once the recorders have ended. Throws as recent() does, and also if one never
  /// recorded.
  void readRest();
  const SlaveWatch& slave() const { return slave_; }
  /// Returns how many records are not in the files.
  std::uint64_t lost() const { return lost_; }
  /// Returns when the clutch was pressed in a run that ended then.
  std::vector<robots::Span> clutched(suture::Time end) const {
    return robots::clutched(clutch_, end);
  }
  /// Judges the whole run, after readRest(). `excused` is when the slave need not follow, beside
  /// the time in which the clutch was pressed.
  robots::Judgement finish(suture::Time end, std::vector<robots::Span> excused);

 private:
  void take(const robots::Recording& master, const robots::Recording& teleop,
            const robots::Recording& slave);

  const Following following_;
  robots::RecordingReader master_, teleop_;
  SlaveWatch slave_;
  robots::Judge judge_;
  std::vector<robots::ClutchNews> clutch_;
  std::uint64_t lost_ = 0;
};

/// Watches each slave that is judged.
struct Watches {
  /// Throws suture::SetupError if nothing records a slave that is driven.
  explicit Watches(const Plan& plan);

  /// Reads on. Returns the error since the last call of the slave that was farthest off, in m at
  /// p99; none if there is nothing to compare.
  std::optional<double> worstError();

  std::vector<FollowingWatch> followings;
  std::vector<SlaveWatch> others;  ///< slaves that follow no master alone
};

}  // namespace demo
