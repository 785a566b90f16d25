#include "bench/local/options.h"

#include "bench/placement.h"

namespace bench {

LocalOptions::LocalOptions() : cpu(preferredCpu()), otherCpu(cpuBeside(cpu)) {}

void LocalOptions::addTo(CLI::App& options) {
  options.add_option("--cpu", cpu, "processor for what runs on one")->capture_default_str();
  options.add_option("--other-cpu", otherCpu, "processor for what runs beside it")
      ->capture_default_str();
  options.add_flag("--quick", quick, "a hundredth: shows that it works, not how well");
}

nlohmann::json LocalOptions::toJson() const {
  return {{"cpu", cpu}, {"other_cpu", otherCpu}, {"quick", quick}};
}

}  // namespace bench
