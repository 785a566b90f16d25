#pragma once
// This is the verdict on a run: the figures of each connection and arm, and if they are good
// enough.

#include <suture/observe/report.h>

#include <optional>
#include <string>
#include <vector>

#include "following_watch.h"
#include "recorder/hold_judge.h"
#include "recorder/knot_judge.h"
#include "run/plan.h"
#include "run/processes.h"

namespace demo {

struct ArmFigures {
  std::string name;  ///< "right:PSM1"
  suture::TaskReport task;
  std::string master;                          ///< "": nothing drives it
  std::optional<robots::Judgement> following;  ///< set for a slave whose run could be judged
  std::optional<robots::JumpJudgement> jumps;  ///< set for each slave that was recorded
};

/// A HeldSlave is a slave that had to hold, while a process was cut off, or the emergency stop or
/// the clutch was pressed.
struct HeldSlave {
  std::string name;
  robots::HoldJudgement judgement;
};

struct Check {
  bool passed;
  std::string text;
};

struct Verdict {
  std::vector<suture::ConnectionReport> connections;
  std::vector<ArmFigures> arms;
  std::optional<robots::KnotJudgement> knot;  ///< set for a run that recorded one
  std::vector<HeldSlave> held;
  std::vector<Check> checks;

  bool passed() const;
};

/// Reads the recordings to their end. An interrupted run is judged too.
Verdict judgeRun(const Plan& plan, const std::optional<Break>& cutOff, const CrewResult& result,
                 Watches& watches);

}  // namespace demo
