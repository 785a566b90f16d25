// This is suture-bench network: what carries the traffic between two processes.

#include "bench/network/rows.h"
#include "bench/parts.h"

namespace bench {
namespace {

constexpr Part<NetworkOptions> kNetworkParts[] = {{"round trips", roundTripRows},
                                                  {"reads", mirrorRows},
                                                  {"fan-out", networkFanOutRows},
                                                  {"allocations", allocationRows},
                                                  {"images", imageRows},
                                                  {"connections", linkTimeRows},
                                                  {"idle", idleRows},
                                                  {"sleeping", sleepingRows},
                                                  {"sizes", sizeRows},
                                                  {"streams", streamRows},
                                                  {"survivors", survivorRows}};

}  // namespace

std::unique_ptr<Benchmark> makeNetwork() {
  return std::make_unique<PartsBenchmark<NetworkOptions>>(
      "network", "each lane between two processes, beside bare memory and sockets", kNetworkParts);
}

}  // namespace bench
