#pragma once
// This judges while a slave is recorded that it does not jump.

#include <cstdint>
#include <vector>

#include "recorder/jump_judge.h"
#include "recorder/recording.h"
#include "run/plan.h"

namespace demo {

/// One thread. Reads the recording of one slave.
class SlaveWatch {
 public:
  explicit SlaveWatch(const RecordedSlave& slave) : slave_(slave), reader_(slave.recording) {}

  const RecordedSlave& slave() const { return slave_; }
  /// Returns what is new since the last call; reading throws as that of RecordingReader.
  robots::Recording next() { return judged(reader_.next()); }
  /// Returns the rest, once the recorder has ended.
  robots::Recording rest() { return judged(reader_.rest()); }
  /// Return what was found until now, and how many records are not in the file.
  robots::JumpJudgement jumps() const { return judge_.judgement(); }
  std::uint64_t lost() const { return lost_; }
  /// Returns the stops of which its recorder heard.
  const std::vector<robots::StopNews>& stops() const { return stops_; }

 private:
  robots::Recording judged(robots::Recording recording) {
    judge_.add(recording.arm);
    stops_.insert(stops_.end(), recording.stops.begin(), recording.stops.end());
    lost_ = recording.lost;
    return recording;
  }

  const RecordedSlave slave_;
  robots::RecordingReader reader_;
  robots::JumpJudge judge_;
  std::vector<robots::StopNews> stops_;
  std::uint64_t lost_ = 0;
};

}  // namespace demo
