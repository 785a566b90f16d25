// suture-bench local: what carries the traffic within one process.

#include <fmt/format.h>

#include <cstdio>

#include "bench/benchmark.h"
#include "bench/local/options.h"
#include "bench/local/rows.h"
#include "bench/progress.h"

namespace bench {
namespace {

struct Part {
  const char* title;
  std::string (*measure)(const LocalOptions& options, Report& report);
};

constexpr Part kParts[] = {
    {"ring", ringRow},
    {"reads", readRows},
    {"CSC", cscRows},
    {"fan-out", fanOutRow},
    {"throughput", throughputRows},
    {"jitter", jitterRows},
};

class Local final : public Benchmark {
 public:
  const char* name() const override { return "local"; }
  const char* description() const override {
    return "rings, state table, commands, events and periodic tasks within one process";
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
  LocalOptions options_;
};

}  // namespace

std::unique_ptr<Benchmark> makeLocal() { return std::make_unique<Local>(); }

}  // namespace bench
