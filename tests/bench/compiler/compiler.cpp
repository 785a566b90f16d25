// This is suture-bench compiler: what suturec costs, what it makes run again, and what its code
// costs.

#include <fmt/format.h>
#include <suture/base/errors.h>

#include <cstdio>
#include <map>
#include <string>

#include "bench/benchmark.h"
#include "bench/compiler/parts.h"
#include "bench/placement.h"
#include "support/temporary_directory.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

using Rows = std::string (*)(const CompilerOptions&, Report&);
const std::map<std::string, Rows> kCompilerParts = {
    {"codec", codecRows}, {"compile", compileRows}, {"rebuild", rebuildRows}, {"tool", toolRows}};

class Compiler final : public Benchmark {
 public:
  Compiler() { options_.cpu = preferredCpu(); }
  const char* name() const override { return "compiler"; }
  const char* description() const override {
    return "suturec itself, what it makes a build do again, and what its code costs to run and to "
           "compile";
  }
  void addOptions(CLI::App& options) override {
    options.add_option("--rounds", options_.rounds, "runs of each program")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000));
    options.add_option("--cpu", options_.cpu, "processor that everything runs on")
        ->capture_default_str();
    options.add_option("--part", options_.part, "codec, compile, rebuild or tool alone")
        ->check(CLI::IsMember({"codec", "compile", "rebuild", "tool"}));
    options.add_flag("--quick", options_.quick, "one round: shows that it works, not how well");
  }

  void run(Report& report) override {
    report.note("options",
                {{"rounds", options_.rounds}, {"cpu", options_.cpu}, {"quick", options_.quick}});
    const suture::TemporaryDirectory scratch;
    options_.scratch = scratch.path();
    const Pinned pinned(options_.cpu);
    for (const auto& [part, rows] : kCompilerParts) {
      if (!options_.part.empty() && options_.part != part) continue;
      fmt::print("{}\n", rows(options_, report));
      std::fflush(stdout);
    }
  }

 private:
  CompilerOptions options_;
};

}  // namespace

std::unique_ptr<Benchmark> makeCompiler() { return std::make_unique<Compiler>(); }

}  // namespace bench
