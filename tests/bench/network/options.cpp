#include "bench/network/options.h"

#include "bench/placement.h"

namespace bench {

NetworkOptions::NetworkOptions() : cpu(preferredCpu()), otherCpu(cpuBeside(cpu)) {}

void NetworkOptions::addTo(CLI::App& options) {
  options.add_option("--cpu", cpu, "the processor of both ends")->capture_default_str();
  options.add_option(
      "--lane", lane,
      "of the round trips and sizes only those of this lane, such as frame.tcp, and for longer");
  options.add_flag("--quick", quick, "a hundredth of the samples: the figures mean nothing");
}

nlohmann::json NetworkOptions::toJson() const {
  return {{"cpu", cpu}, {"other_cpu", otherCpu}, {"quick", quick}, {"lane", lane}};
}

}  // namespace bench
