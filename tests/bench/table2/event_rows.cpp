#include "bench/table2/event_rows.h"

#include <fmt/format.h>

#include <map>
#include <string>

#include "bench/figures/table.h"
#include "bench/placement.h"
#include "bench/progress.h"
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
    {"one way", "event.one_way", Loop::OneWay, &LoopResult::elapsed, ""},
};

std::string nameOf(Loop loop) {
  switch (loop) {
    case Loop::Scs: return "SCS";
    case Loop::Csc: return "CSC";
    case Loop::OneWay: return "one way";
  }
  return "";
}

struct Both {
  LoopResult local, network;
};

Both measureBoth(const Table2Options& options, Loop loop) {
  const LoopSetup setup = options.eventDriven(loop);
  progress("event-driven " + nameOf(loop));
  return {measureLocally(setup), measureAcross(setup, options.between())};
}

/// Adds a row; `floor` is what a bare socket takes for as much of a round trip, us.
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
  std::map<Loop, Both> results;
  for (const Loop loop : {Loop::Scs, Loop::Csc, Loop::OneWay}) {
    results.emplace(loop, measureBoth(options, loop));
  }
  const Statistics rawUnix = bareRounds(Transport::Unix, options, payloadBytes),
                   rawTcp = bareRounds(Transport::Tcp, options, payloadBytes);
  const Statistics& round = options.between().transport == Transport::Unix ? rawUnix : rawTcp;
  for (const EventRow& row : kEventRows) {
    const double floor = row.loop == Loop::OneWay ? round.p50 / 2 : round.p50;
    addRow(row, results.at(row.loop), floor, table, report);
  }
  table.line();
  report.add("raw.unix", "us", rawUnix);
  report.add("raw.tcp", "us", rawTcp);
  table.row(joined({"raw socket", "unix"}, cellsOf(rawUnix, 1)));
  table.row(joined({"", "tcp"}, cellsOf(rawTcp, 1)));
  progress("");
  std::size_t failures = 0;
  for (const auto& [loop, both] : results) failures += both.local.failures + both.network.failures;
  report.add("event.failures", "calls", static_cast<double>(failures));
  return fmt::format(
      "Event-driven, all threads of both processes on processor {}, {} samples after {}; "
      "network = {}; us\n\n{}\n"
      "SCS: from the stamp that fresh() brings to the handler of the blocking write. SCS, client: "
      "fresh() and the whole blocking write, two round trips. One way: from the client's stamp to "
      "the "
      "handler of its write; both processes read one clock.\n"
      "Raw socket: a blocking round trip of {} bytes between two processes on that processor, of "
      "which one way is given half. "
      "Over Ice: what the original adds.{}\n",
      options.cpu, options.kept(), options.skipped(), options.betweenInWords(), table.toString(),
      payloadBytes,
      failures == 0 ? ""
                    : fmt::format("\n{} calls failed or were not answered in time.", failures));
}

}  // namespace bench
