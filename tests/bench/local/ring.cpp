#include <suture/rt/queue/spsc_ring.h>

#include <array>
#include <cstring>

#include "bench/figures/table.h"
#include "bench/local/rows.h"
#include "bench/timed_loops.h"

namespace bench {

std::string ringRow(const LocalOptions& options, Report& report) {
  using RingCommand = std::array<std::byte, 128>;
  suture::rt::SpscRing ring(64 * suture::rt::SpscRing::recordSize(sizeof(RingCommand)),
                            sizeof(RingCommand));
  RingCommand sent{}, taken{};
  const Statistics cost = timedLoops(options.count(200), 100'000, [&] {
    std::memcpy(ring.claim(sizeof(RingCommand)), sent.data(), sizeof(RingCommand));
    ring.commit();
    std::memcpy(taken.data(), ring.front(), sizeof(RingCommand));
    ring.pop();
    keep(taken);
  });
  report.add("ring", "ns", cost);
  Table table(1);
  table.row(joined({"ns, one thread"}, statisticsTitles()));
  table.line();
  table.row(joined({"128-byte command in and out of a ring"}, cellsOf(cost, 1)));
  return table.toString();
}

}  // namespace bench
