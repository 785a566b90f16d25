#pragma once
// This decides from a recording if an arm moved without a jump during a whole run.

#include <Eigen/Core>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "recorder/jumps.h"
#include "recorder/recording.h"

namespace robots {

struct JumpJudgement {
  Jumps setpoint;
  double astray = 0;  ///< m: how far the arm was from the path of its set-points, at most
};

/// Judges an arm while it is recorded, however late anybody is: a set-point may have moved for as
/// long as no row came, or the data from which it was made grew older; and drives that trail go
/// along the path of the set-points. So it sees no jump between two rows that are far apart.
class JumpJudge {
 public:
  /// Rows must come by ascending stamp.
  void add(const std::vector<ArmRow>& rows);
  JumpJudgement judgement() const { return {watch_.jumps(), astray_}; }

 private:
  void add(const ArmRow& row);
  double motionUntil(const ArmRow& row) const;
  double fromPath(const Eigen::Vector3d& tip) const;

  JumpWatch watch_;
  std::optional<ArmRow> last_;
  std::deque<Eigen::Vector3d> path_;  // the last set-points, m
  double astray_ = 0;
};

/// Returns each bound that is missed, in words: those of jumps, and 5 mm from the path, which is as
/// far as a tip falls while a controller of drives with mass is 30 ms late.
std::vector<std::string> violations(const JumpJudgement& judgement);

}  // namespace robots
