// This is suture-bench: every performance figure of the project, and if it keeps to its bound.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>

#include "bench/benchmark.h"
#include "bench/figures/bounds.h"
#include "bench/figures/machine.h"
#include "bench/network/processes/arm_process.h"
#include "bench/network/processes/image_process.h"
#include "bench/network/processes/sample_process.h"
#include "bench/network/processes/subscriber_process.h"
#include "bench/network/sizes/block_process.h"
#include "bench/stop/stop_process.h"
#include "bench/table2/processes/server_process.h"

namespace {

using bench::Benchmark;
using bench::Report;

/// Holds the options that all subcommands share.
struct CommonOptions {
  std::string jsonFile;
  bool check = false;
  std::string boundsFile;
};

void writeJson(const Report& report, const std::string& file) {
  std::ofstream out(file);
  out << report.toJson().dump(2) << '\n';
  if (!out.flush()) throw std::runtime_error("cannot write the figures to '" + file + "'");
}

std::vector<bench::Bound> readBounds(const std::string& file) {
  if (file.empty()) return bench::parseBounds(bench::boundsText());
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read the bounds in '" + file + "'");
  return bench::parseBounds(std::string(std::istreambuf_iterator<char>(in), {}));
}

/// Prints what falls short. Returns true if nothing does.
bool keepsItsBounds(const Report& report, const std::string& subcommand, const std::string& file) {
  const auto bounds = readBounds(file);
  const auto lines = bench::shortfalls(bounds, subcommand, report);
  for (const std::string& line : lines) fmt::print("falls short: {}\n", line);
  if (lines.empty()) fmt::print("All bounds of {} are kept.\n", subcommand);
  return lines.empty();
}

int run(Benchmark& benchmark, const CommonOptions& options) {
  Report report;
  report.note("subcommand", benchmark.name());
  report.note("machine", bench::describeMachine());
  benchmark.run(report);
  if (!options.jsonFile.empty()) writeJson(report, options.jsonFile);
  if (!options.check) return 0;
  return keepsItsBounds(report, benchmark.name(), options.boundsFile) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App program{
      "Measures Suture. Each subcommand prints tables; --check compares them with their bounds."};
  program.require_subcommand(1);
  bench::addServerProcess(program);
  bench::addSampleProcess(program);
  bench::addArmProcess(program);
  bench::addSubscriberProcess(program);
  bench::addImageProcess(program);
  bench::addBlockProcess(program);
  bench::addStopProcess(program);

  int status = 0;
  const auto table2 = bench::makeTable2();
  const auto local = bench::makeLocal();
  const auto network = bench::makeNetwork();
  const auto stop = bench::makeStop();
  const auto compiler = bench::makeCompiler();
  const auto kinematics = bench::makeKinematics();
  const auto fixtures = bench::makeFixtures();
  CommonOptions options;
  for (Benchmark* benchmark : {table2.get(), local.get(), network.get(), stop.get(), compiler.get(),
                               kinematics.get(), fixtures.get()}) {
    CLI::App* subcommand = program.add_subcommand(benchmark->name(), benchmark->description());
    subcommand->add_option("--json", options.jsonFile, "writes every figure to this file");
    subcommand->add_flag("--check", options.check,
                         "compares with the bounds; the exit status is 1 if a figure falls short");
    subcommand->add_option("--bounds", options.boundsFile, "other bounds than those built in");
    benchmark->addOptions(*subcommand);
    subcommand->callback([&status, benchmark, &options] { status = run(*benchmark, options); });
  }
  CLI11_PARSE(program, argc, argv);
  return status;
} catch (const std::exception& error) {
  fmt::print(stderr, "suture-bench: {}\n", error.what());
  return 2;
}
