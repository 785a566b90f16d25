#pragma once
// Judges the slaves while they are recorded.

#include <string>
#include <vector>

#include "recorder/judge.h"
#include "recorder/recording.h"
#include "run/plan.h"

namespace demo {

/// One slave that follows one master. One thread.
class FollowingWatch {
 public:
  explicit FollowingWatch(const Following& following);

  const Following& following() const { return following_; }
  /// How far off the slave was since the last call, by what has been recorded until now. Throws
  /// suture::SetupError if a recording cannot be read.
  robots::ErrorSummary recent();
  /// The whole run, once the recorders have ended. Throws as recent(), also if one never recorded.
  robots::Judgement finish();

 private:
  const Following following_;
  robots::RecordingReader master_, teleop_, slave_;
  robots::Judge judge_;
};

std::vector<FollowingWatch> watchAll(const std::vector<Following>& followings);

}  // namespace demo
