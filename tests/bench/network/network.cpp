// suture-bench network: what carries the traffic between two processes.

#include <fmt/format.h>

#include <cstdio>

#include "bench/benchmark.h"
#include "bench/network/rows.h"
#include "bench/progress.h"

namespace bench {
namespace {

struct Part {
  const char* title;
  std::string (*measure)(const NetworkOptions& options, Report& report);
};

constexpr Part kParts[] = {{"round trips", roundTripRows},
                           {"reads", mirrorRows},
                           {"fan-out", networkFanOutRows},
                           {"allocations", allocationRows},
                           {"connections", linkTimeRows}};

class Network final : public Benchmark {
 public:
  const char* name() const override { return "network"; }
  const char* description() const override {
    return "each lane between two processes, beside bare memory and sockets";
  }
  void addOptions(CLI::App& options) override { options_.addTo(options); }

  void run(Report& report) override {
    report.note("options", options_.toJson());
    for (const Part& part : kParts) {
      progress(part.title);
      const std::string table = part.measure(options_, report);
      progress("");
      fmt::print("{}\n", table);
      std::fflush(stdout);
    }
  }

 private:
  NetworkOptions options_;
};

}  // namespace

std::unique_ptr<Benchmark> makeNetwork() { return std::make_unique<Network>(); }

}  // namespace bench
