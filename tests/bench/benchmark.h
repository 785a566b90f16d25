#pragma once
// This is a subcommand of suture-bench.

#include <CLI/CLI.hpp>
#include <memory>

#include "bench/figures/report.h"

namespace bench {

/// Measures, prints its tables and leaves every figure in the report. `--json` and `--check` are
/// added to each by the program.
class Benchmark {
 public:
  virtual ~Benchmark() = default;
  virtual const char* name() const = 0;
  virtual const char* description() const = 0;
  virtual void addOptions(CLI::App& options) = 0;
  /// Throws what it cannot handle; the program then ends with an error.
  virtual void run(Report& report) = 0;
};

/// Measures the loops and the overhead of the paper's Table 2.
std::unique_ptr<Benchmark> makeTable2();
/// Measures suturec itself and the code that it writes.
std::unique_ptr<Benchmark> makeCompiler();
/// Measures what carries the traffic within one process.
std::unique_ptr<Benchmark> makeLocal();
/// Measures what carries the traffic between processes.
std::unique_ptr<Benchmark> makeNetwork();
/// Measures the emergency stop of a system.
std::unique_ptr<Benchmark> makeStop();
/// Measures what the arms compute in each cycle.
std::unique_ptr<Benchmark> makeKinematics();
/// Measures what a guided motion solves in each cycle.
std::unique_ptr<Benchmark> makeFixtures();

}  // namespace bench
