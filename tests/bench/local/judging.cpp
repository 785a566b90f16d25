#include <suture/base/slots/shared_slot.h>
#include <suture/component/contract/interface_info.h>

#include <algorithm>

#include "bench/figures/table.h"
#include "bench/local/rows.h"
#include "bench/sample_loop.suture.h"
#include "bench/timed_loops.h"

namespace bench {

std::string judgingRow(const LocalOptions& options, Report& report) {
  const auto& commands = suture::interfaceInfo<SampleServer>().commands;
  const suture::CommandInfo& read = *std::find_if(commands.begin(), commands.end(),
                                                  [](const auto& one) { return one.column == 0; });
  suture::LooseSlot<robots::PoseSampleSlot> slot;
  store(robots::PoseSample{}, slot.value());
  const Statistics cost = timedLoops(options.count(200), 100'000, [&] {
    keep(slot);
    const bool admitted = read.admitsResult(slot.memory());
    keep(admitted);
  });
  report.add("judging", "ns", cost);
  Table table(1);
  table.row(joined({"ns"}, statisticsTitles()));
  table.line();
  table.row(joined({"a PoseSample is judged"}, cellsOf(cost, 1)));
  return table.toString();
}

}  // namespace bench
