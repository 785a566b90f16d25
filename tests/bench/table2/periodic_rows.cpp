#include "bench/table2/periodic_rows.h"

#include <fmt/format.h>

#include "bench/figures/table.h"
#include "bench/placement.h"
#include "bench/progress.h"
#include "bench/table2/measure.h"
#include "bench/table2/paper.h"

namespace bench {
namespace {

struct Policy {
  const char* title;
  const char* figure;
  bool fifo;
  const paper::System& paper;
};

constexpr Policy kPolicies[] = {
    {"SCHED_OTHER", "other", false, paper::kLinux},
    {"SCHED_FIFO", "fifo", true, paper::kLinuxRtai},
};

std::vector<std::string> paperCells(const paper::Row& row) {
  return {"|", number(row.mean, 3), number(row.std, 3), number(row.min, 3), number(row.max, 3)};
}

/// Measures one loop under one policy, reports its figures and adds its rows to the table.
class LoopRows {
 public:
  LoopRows(const Policy& policy, Loop loop, Table& table, Report& report)
      : policy_(policy),
        scs_(loop == Loop::Scs),
        figure_(std::string(policy.figure) + (scs_ ? ".scs" : ".csc")),
        table_(table),
        report_(report) {}

  void measure(const LoopSetup& setup, const Between& between) {
    const std::string what = std::string(policy_.title) + (scs_ ? " SCS" : " CSC");
    progress(what + " local");
    const Statistics local = add("local", measureLocally(setup));
    progress(what + " network");
    const Statistics network = add("network", measureAcross(setup, between));
    print(local, network);
    report_.add(figure_ + ".difference.mean", "ms", network.mean - local.mean);
    report_.add(figure_ + ".difference.p50", "ms", network.p50 - local.p50);
  }

  void unavailable(const std::string& reason) {
    for (const char* part : {".local", ".network", ".difference.mean", ".difference.p50"}) {
      report_.addUnavailable(figure_ + part, reason);
    }
    const std::vector<std::string> none(7, "n/a");
    table_.row(joined(joined(names("local"), none), paperCells(local())));
    table_.row(joined(joined({"", "", "network"}, none), paperCells(network())));
    printDifference("n/a", "n/a");
  }

 private:
  const paper::Row& local() const { return scs_ ? policy_.paper.scsLocal : policy_.paper.cscLocal; }
  const paper::Row& network() const {
    return scs_ ? policy_.paper.scsNetwork : policy_.paper.cscNetwork;
  }

  std::vector<std::string> names(const char* where) const {
    return {policy_.title, scs_ ? "SCS" : "CSC", where};
  }

  Statistics add(const char* part, const LoopResult& result) {
    const Statistics statistics = statisticsOf(inUnits(result.elapsed, kMillisecond));
    report_.add(figure_ + "." + part, "ms", statistics);
    return statistics;
  }

  void print(const Statistics& here, const Statistics& across) {
    table_.row(joined(joined(names("local"), cellsOf(here, 3)), paperCells(local())));
    table_.row(joined(joined({"", "", "network"}, cellsOf(across, 3)), paperCells(network())));
    printDifference(number(across.mean - here.mean, 3), number(across.p50 - here.p50, 3));
  }

  void printDifference(const std::string& mean, const std::string& median) {
    const double paper = scs_ ? policy_.paper.scsDifference : policy_.paper.cscDifference;
    table_.row({"", "", "difference", mean, "", "", median, "", "", "", "|", number(paper, 3)});
  }

  const Policy& policy_;
  const bool scs_;
  const std::string figure_;
  Table& table_;
  Report& report_;
};

}  // namespace

std::string periodicRows(const Table2Options& options, Report& report) {
  Table table(3);
  table.row(joined(joined(
                       {
                           "",
                           "",
                           "",
                       },
                       std::vector<std::string>(7)),
                   {"|", "paper:"}));
  table.row(joined(joined({"scheduling", "loop", "where"}, statisticsTitles()),
                   {"|", "avg", "std", "min", "max"}));
  std::string notes;
  for (const Policy& policy : kPolicies) {
    table.line();
    const std::string reason = policy.fifo ? whyNotFifo(options.fifoPriority) : "";
    if (!reason.empty()) notes += "SCHED_FIFO is not available here: " + reason + "\n";
    for (const Loop loop : {Loop::Scs, Loop::Csc}) {
      LoopRows rows(policy, loop, table, report);
      if (reason.empty()) {
        rows.measure(options.periodic(loop, policy.fifo), options.between());
      } else {
        rows.unavailable(reason);
      }
    }
  }
  return fmt::format(
      "Table 2: round a loop of two periodic tasks, {:g} Hz, PosePrm, {} samples after {} skipped; "
      "network = {}; ms\n\n{}\n{}"
      "The paper's rows: Linux beside SCHED_OTHER, Linux with RTAI beside SCHED_FIFO.\n"
      "The paper's values are quantised by a clock of 4 ms: its minima, maxima and deviations say "
      "nothing of latency, its means only by their difference.\n"
      "At such periods the phase of the two tasks decides, not the network. So the same loops "
      "are measured again below, with tasks that sleep until something arrives:\n",
      options.rateHz, options.kept(), options.skipped(), options.betweenInWords(), table.toString(),
      notes);
}

}  // namespace bench
