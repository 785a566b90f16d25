#pragma once
// Decides from recordings whether a slave did what the law asks of it. Nothing is fitted: the path
// is the recorded master's, the times are the stamps that travelled with the data, the lag is the
// declared one.

#include <cstddef>
#include <string>
#include <vector>

#include "recorder/recording.h"

namespace robots {

struct ErrorSummary {
  double p50 = 0, p99 = 0, max = 0;
};

struct Judgement {
  ErrorSummary position;     ///< m
  ErrorSummary orientation;  ///< rad
  double travel = 0;         ///< m: how far the slave got from where it was when following began
  std::size_t compared = 0;  ///< slave cycles
  /// Slave cycles whose master pose is not in the master's recording; they are not compared.
  std::size_t unmatched = 0;
};

/// `master` and `slave` by ascending stamp, on one clock; `followed` is what the teleoperation
/// between them announced. From the first entry on, the law x_s = x_s0 + s (x_m - x_m0), R_s = R_m
/// R_m0^T R_s0 gives the target of each slave cycle from the recorded master at the stamp of the
/// set-point; a first-order filter of `timeConstant` (s) in Cartesian space, on the slave's own
/// cycle times, gives where the slave should be. Rate limits are not modelled: a slave that met one
/// is late, and that shows.
Judgement judge(const std::vector<ArmRow>& master, const std::vector<FollowAnchors>& followed,
                const std::vector<ArmRow>& slave, double timeConstant);

struct JudgementBounds {
  double position = 0.001;          ///< m, at p99
  double orientation = 0.01745329;  ///< rad, at p99: one degree
  double travel = 0.03;             ///< m, at least
  double unmatched = 0.05;  ///< share of cycles, at most: recorders do not stop at one instant
};

/// Each bound that is missed, in words; empty: the slave did well.
std::vector<std::string> violations(const Judgement& judgement, const JudgementBounds& bounds = {});

}  // namespace robots
