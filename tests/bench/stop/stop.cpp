// This is suture-bench stop: how soon an emergency stop stops the drives of four arms, while images
// flow.

#include "bench/figures/table.h"
#include "bench/network/lanes.h"
#include "bench/parts.h"
#include "bench/placement.h"
#include "bench/stop/options.h"
#include "bench/stop/system.h"

namespace bench {
namespace {

void add(Report& report, Table& table, const std::string& figure, const char* words,
         const std::vector<std::int64_t>& nanoseconds) {
  const Statistics statistics = statisticsOf(inUnits(nanoseconds, kMillisecond));
  report.add(figure, "ms", statistics);
  table.row(joined({figure, words}, cellsOf(statistics, 2)));
}

/// Leaves "local", "shm", ...: from a press to the stop of the last drives; and "cut.shm", ...:
/// from when the coordinator's process stands still; "killed.shm", ...: from when it is killed,
/// once;
/// ".images": how many both pairs saw meanwhile.
void measure(const std::string& name, const suture::Lane& lane, const StopOptions& options,
             Report& report, Table& table) {
  StopSystem system(lane);
  std::vector<std::int64_t> presses, cuts;
  for (int i = 0; i < options.presses(); ++i) presses.push_back(system.press());
  add(report, table, name, "pressed", presses);
  if (lane != suture::Lane::Auto) {
    for (int i = 0; i < options.cuts(); ++i) cuts.push_back(system.cutOff());
    add(report, table, "cut." + name, "coordinator stands still", cuts);
    add(report, table, "killed." + name, "coordinator is killed", {system.killDesk()});
  }
  report.add(name + ".images", "images", static_cast<double>(system.end()));
}

std::string stopRows(const StopOptions& options, Report& report) {
  Table table(2);
  table.row(joined({"stop, ms", ""}, statisticsTitles()));
  table.line();
  measure("local", suture::Lane::Auto, options, report, table);
  for (const suture::Lane& lane : kLanes) measure(toString(lane), lane, options, report, table);
  const bool fifo = urgent(80) != suture::rt::Scheduling{};
  return table.toString() + (fifo ? "drives, coordinator and connections: SCHED_FIFO\n"
                                  : "no real-time priorities: this user may have none\n");
}

constexpr Part<StopOptions> kStopParts[] = {{"stops", stopRows}};

}  // namespace

std::unique_ptr<Benchmark> makeStop() {
  return std::make_unique<PartsBenchmark<StopOptions>>(
      "stop", "how soon an emergency stop stops four arms, while images flow", kStopParts);
}

}  // namespace bench
