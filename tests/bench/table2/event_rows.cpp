#include "bench/table2/event_rows.h"

#include <fmt/format.h>

#include "bench/placement.h"
#include "bench/progress.h"
#include "bench/table.h"
#include "bench/table2/measure.h"
#include "bench/table2/ping_pong.h"

namespace bench {
namespace {

struct EventRow {
  const char* title;
  const char* figure;
  Loop loop;
  std::vector<std::int64_t> LoopResult::*samples;
  const char* original;
};

constexpr EventRow kEventRows[] = {
    {"SCS", "event.scs", Loop::Scs, &LoopResult::elapsed, ""},
    {"SCS, client", "event.scs_client", Loop::Scs, &LoopResult::client, "about 53"},
    {"CSC", "event.csc", Loop::Csc, &LoopResult::elapsed, "about 40"},
};

struct Both {
  LoopResult local, network;
};

Both measureBoth(const Table2Options& options, Loop loop) {
  const LoopSetup setup = options.eventDriven(loop);
  progress(std::string("event-driven ") + (loop == Loop::Scs ? "SCS" : "CSC"));
  return {measureLocally(setup), measureAcross(setup, options.transport())};
}

/// `floor`: the median of a bare socket's round trip, us.
void addRow(const EventRow& row, const Both& results, double floor, Table& table, Report& report) {
  const Statistics local = statisticsOf(inUnits(results.local.*row.samples, kMicrosecond));
  const Statistics network = statisticsOf(inUnits(results.network.*row.samples, kMicrosecond));
  const double difference = network.p50 - local.p50;
  const std::string figure = row.figure;
  report.add(figure + ".local", "us", local);
  report.add(figure + ".network", "us", network);
  report.add(figure + ".difference", "us", difference);
  report.add(figure + ".ratio", "x", difference / floor);
  table.row(joined({row.title, "local"}, cellsOf(local, 1)));
  table.row(joined({"", "network"}, cellsOf(network, 1)));
  table.row({"", "difference", "", "", "", number(difference, 1), "", "", "",
             number(difference / floor, 1), row.original});
}

Statistics bareRounds(Transport transport, const Table2Options& options, std::size_t bytes) {
  return statisticsOf(inUnits(
      pingPong(transport, bytes, options.cpu, options.skipped(), options.kept()), kMicrosecond));
}

}  // namespace

std::string eventRows(const Table2Options& options, std::size_t payloadBytes, Report& report) {
  const Unpreempted unpreempted;
  Table table(2);
  table.row(joined(joined({"loop", "where"}, statisticsTitles()), {"over raw", "over Ice"}));
  table.line();
  const Both scs = measureBoth(options, Loop::Scs), csc = measureBoth(options, Loop::Csc);
  const Statistics rawUnix = bareRounds(Transport::Unix, options, payloadBytes),
                   rawTcp = bareRounds(Transport::Tcp, options, payloadBytes);
  const Statistics& floor = options.transport() == Transport::Unix ? rawUnix : rawTcp;
  for (const EventRow& row : kEventRows) {
    addRow(row, row.loop == Loop::Scs ? scs : csc, floor.p50, table, report);
  }
  table.line();
  report.add("raw.unix", "us", rawUnix);
  report.add("raw.tcp", "us", rawTcp);
  table.row(joined({"raw socket", "unix"}, cellsOf(rawUnix, 1)));
  table.row(joined({"", "tcp"}, cellsOf(rawTcp, 1)));
  progress("");
  const std::size_t failures =
      scs.local.failures + scs.network.failures + csc.local.failures + csc.network.failures;
  report.add("event.failures", "calls", static_cast<double>(failures));
  return fmt::format(
      "Event-driven, all threads of both processes on processor {}, {} samples after {}; "
      "network = rpc over {}; us\n\n{}\n"
      "SCS: from the stamp that fresh() brings to the handler of the blocking write. SCS, client: "
      "fresh() and the whole blocking write, two round trips.\n"
      "Raw socket: a blocking round trip of {} bytes between two processes on that processor. "
      "Over Ice: what the original adds.{}\n",
      options.cpu, options.kept(), options.skipped(), options.transportName(), table.toString(),
      payloadBytes,
      failures == 0 ? ""
                    : fmt::format("\n{} calls failed or were not answered in time.", failures));
}

}  // namespace bench
