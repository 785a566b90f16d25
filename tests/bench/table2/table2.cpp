// This is suture-bench table2: the paper's Table 2, and the same loops where the network can be
// seen.

#include <fmt/format.h>

#include <cstdio>

#include "bench/benchmark.h"
#include "bench/table2/codec.h"
#include "bench/table2/event_rows.h"
#include "bench/table2/execution.h"
#include "bench/table2/options.h"
#include "bench/table2/overhead.h"
#include "bench/table2/periodic_rows.h"

namespace bench {
namespace {

class Table2 final : public Benchmark {
 public:
  const char* name() const override { return "table2"; }
  const char* description() const override {
    return "the paper's SCS and CSC loops, local and across processes, and what the overhead is "
           "made of";
  }
  void addOptions(CLI::App& options) override { options_.addTo(options); }

  void run(Report& report) override {
    report.note("options", options_.toJson());
    const CodecCost codec = measureCodec(options_.codecLoops());
    const Statistics execution = measureExecution(options_.codecLoops());
    addOverhead(codec, execution, report);
    if (!options_.eventDrivenOnly) fmt::print("{}\n", periodicRows(options_, report));
    fmt::print("{}\n", eventRows(options_, codec.bytes, report));
    fmt::print("{}", overheadRows(codec, execution, report));
    std::fflush(stdout);
  }

 private:
  Table2Options options_;
};

}  // namespace

std::unique_ptr<Benchmark> makeTable2() { return std::make_unique<Table2>(); }

}  // namespace bench
