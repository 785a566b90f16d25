#pragma once
// This judges the slaves while they are recorded.

#include <string>
#include <vector>

#include "recorder/judge.h"
#include "recorder/recording.h"
#include "run/plan.h"

namespace demo {

/// One thread. Judges one slave that follows one master.
class FollowingWatch {
 public:
  explicit FollowingWatch(const Following& following);

  const Following& following() const { return following_; }
  /// Returns how far off the slave was since the last call, by what has been recorded until now.
  /// Throws suture::SetupError if a recording cannot be read.
  robots::ErrorSummary recent();
  /// Judges the whole run, once the recorders have ended. Throws as recent() does, and also if one
  /// never recorded.
  robots::Judgement finish();

 private:
  const Following following_;
  robots::RecordingReader master_, teleop_, slave_;
  robots::Judge judge_;
};

std::vector<FollowingWatch> watchAll(const std::vector<Following>& followings);

}  // namespace demo
