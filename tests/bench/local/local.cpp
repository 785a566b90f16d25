// This is suture-bench local: what carries the traffic within one process.

#include "bench/local/options.h"
#include "bench/local/rows.h"
#include "bench/parts.h"

namespace bench {
namespace {

constexpr Part<LocalOptions> kLocalParts[] = {
    {"clock", clockRows},         {"ring", ringRow},
    {"reads", readRows},          {"judging", judgingRow},
    {"beginning", beginningRows}, {"CSC", cscRows},
    {"fan-out", fanOutRow},       {"throughput", throughputRows},
    {"jitter", jitterRows},
};

}  // namespace

std::unique_ptr<Benchmark> makeLocal() {
  return std::make_unique<PartsBenchmark<LocalOptions>>(
      "local", "rings, state table, commands, events and periodic tasks within one process",
      kLocalParts);
}

}  // namespace bench
