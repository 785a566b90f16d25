#pragma once
// This is what the demo shows.

#include <suture/observe/report.h>

#include <optional>
#include <string>
#include <vector>

#include "run/plan.h"
#include "run/processes.h"
#include "tables/table.h"
#include "verdict.h"

namespace demo {

/// Writes to standard output, in colours if that is a terminal and NO_COLOR is not set.
class Screen {
 public:
  Screen();

  void begin(const Options& options, const Plan& plan, const Network& network);
  /// Writes one line about what happened since the last call, and none at the start, when nothing
  /// has run; `error` is how far the worst slave was off, in m at p99, if there is any to compare.
  /// Ages and jitter are of the whole run so far, because reports have no distributions of less.
  void progress(suture::Duration ran, const std::vector<suture::Report>& reports,
                std::optional<double> error);
  void end(const Plan& plan, const CrewResult& result, const Verdict& verdict);

 private:
  /// Holds sums and worst values over everything that the processes report.
  struct Totals {
    std::uint64_t cycles = 0, executed = 0, replaced = 0, dropped = 0, late = 0, skipped = 0;
    suture::Duration commandAge{}, readAge{}, jitter{};  // p99 of the worst
  };

  static Totals totalsOf(const std::vector<suture::Report>& reports);
  void printTable(const Table& table) const;
  void printSlaves(const std::vector<ArmFigures>& arms) const;
  void printChecks(const std::vector<Check>& checks) const;
  std::string bold(const std::string& text) const;
  std::string verdictMark(bool passed) const;

  const bool colours_;
  Totals shown_;  // by the last line
};

}  // namespace demo
