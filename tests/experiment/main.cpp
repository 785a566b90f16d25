// This is suture-experiment: how well an operator places a knot over a link that is late, uneven
// and lossy.

#include <fmt/format.h>
#include <suture/base/errors.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>
#include <vector>

#include "experiment/agreement.h"
#include "experiment/experiment.h"
#include "experiment/plot.h"
#include "experiment/table.h"

namespace {

using experiment::Axis;
using experiment::kAgrees;
using experiment::Limit;
using experiment::Trial;
using experiment::TrialResult;

struct Options {
  bool quick = false, realTime = false;
  std::uint32_t seed = 1;
  std::string csv, png;
};

bool isMet(const Limit& limit) { return std::abs(limit.measured / limit.byFormula - 1) <= kAgrees; }

Limit tellLimit(Axis axis, const char* name) {
  const Limit limit = experiment::findLimit(axis);
  fmt::print(
      "The operator's own limit {} the strand, round trip: {:.0f} ms by pi/(2 w_c) - tau - {:.0f} "
      "ms "
      "of the loop, {:.1f} ms measured: {:+.1f} %{}\n",
      name, 1e3 * limit.byFormula, 1e3 * limit.loop, 1e3 * limit.measured,
      1e2 * (limit.measured / limit.byFormula - 1),
      isMet(limit) ? "" : ", which is not met within 10 %");
  std::fflush(stdout);
  return limit;
}

/// Tells each line as soon as it is known, since a grid takes its time.
std::vector<TrialResult> runAll(const std::vector<Trial>& trials, std::ofstream* csv) {
  const auto tell = [csv](const std::string& line) {
    fmt::print("{}\n", line);
    std::fflush(stdout);
    if (csv != nullptr) *csv << line << std::endl;
  };
  tell(experiment::header());
  std::vector<TrialResult> results;
  for (const Trial& trial : trials) {
    results.push_back({trial, experiment::run(trial)});
    tell(experiment::row(trial, results.back().result));
  }
  return results;
}

std::ofstream opened(const std::string& file) {
  std::ofstream out(file);
  if (out) return out;
  throw suture::SetupError("writing the results to " + file, "the file cannot be written",
                           "Name a file in an existing folder that you may write to");
}

/// Returns that of the demo's arms, if this user may have it.
suture::rt::Scheduling scheduling() {
  const auto granted =
      suture::rt::grantedOf("the two sides", {.policy = suture::rt::Policy::Fifo, .priority = 70});
  for (const std::string& refusal : granted.refusals) fmt::print(stderr, "{}\n", refusal);
  return granted.scheduling;
}

experiment::Point runBothWays(Trial trial, std::uint32_t firstSeed,
                              const suture::rt::Scheduling& threads) {
  experiment::Point point{.trial = trial, .real = {}, .stepped = {}};
  for (std::uint32_t i = 0; i < experiment::kSeeds; ++i) {
    trial.seed = firstSeed + i;
    const auto real = experiment::runInRealTime(trial, threads);
    point.real.push_back(real.result);
    point.packets += real.packets;
    point.lost += real.lost;
    point.stepped.push_back(experiment::run(trial));
  }
  return point;
}

/// Returns the program's exit status.
int compare(const Options& options) {
  const suture::rt::Scheduling threads = scheduling();
  fmt::print(
      "Both sides of the link in real time, scheduled as {}:\n"
      "          placed after   knot off  tracking p50, p99      guided\n",
      toString(threads));
  bool all = true;
  for (const Trial& trial : experiment::realTimePoints()) {
    const experiment::Point point = runBothWays(trial, options.seed, threads);
    fmt::print("{}", experiment::describe(point));
    std::fflush(stdout);
    all = all && experiment::agrees(point);
  }
  return all ? 0 : 1;
}

/// Returns the program's exit status.
int work(const Options& options) {
  std::ofstream csv;
  if (!options.csv.empty()) csv = opened(options.csv);
  const Limit along = tellLimit(Axis::AlongStrand, "along");
  const Limit across = tellLimit(Axis::AcrossStrand, "across");
  auto trials = options.quick ? experiment::quickGrid() : experiment::fullGrid();
  for (Trial& trial : trials) trial.seed = options.seed;
  const auto results = runAll(trials, options.csv.empty() ? nullptr : &csv);
  // The knot is placed along both axes, so the lower limit counts.
  const Limit& lower = along.measured < across.measured ? along : across;
  if (!options.png.empty()) experiment::plot(options.png, results, lower);
  return isMet(along) && isMet(across) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App program{"An operator places a knot over a link: error and time against its delay."};
  Options options;
  program.add_flag("--quick", options.quick, "a coarse grid, some minutes");
  program.add_flag("--real-time", options.realTime,
                   "six points in real time, over the kernel's TCP, beside the stepped clock's");
  program.add_option("--seed", options.seed, "of noise, tremor, jitter and loss; 1 by default");
  program.add_option("--csv", options.csv, "writes the results to this file");
  program.add_option("--png", options.png, "draws the results into this file");
  CLI11_PARSE(program, argc, argv);
  return options.realTime ? compare(options) : work(options);
} catch (const std::exception& error) {
  fmt::print(stderr, "suture-experiment: {}\n", error.what());
  return 2;
}
