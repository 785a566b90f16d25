#pragma once
// A subcommand that measures one thing after the other.

#include <fmt/format.h>

#include <cstdio>
#include <span>
#include <string>

#include "bench/benchmark.h"
#include "bench/progress.h"

namespace bench {

template <class Options>
struct Part {
  const char* title;
  /// Its table.
  std::string (*measure)(const Options& options, Report& report);
};

/// Says which part runs, and prints each table as soon as it is there.
template <class Options>
class PartsBenchmark final : public Benchmark {
 public:
  /// The texts and the parts are kept by reference.
  PartsBenchmark(const char* name, const char* description, std::span<const Part<Options>> parts)
      : name_(name), description_(description), parts_(parts) {}

  const char* name() const override { return name_; }
  const char* description() const override { return description_; }
  void addOptions(CLI::App& options) override { options_.addTo(options); }

  void run(Report& report) override {
    report.note("options", options_.toJson());
    for (const Part<Options>& part : parts_) {
      progress(part.title);
      const std::string table = part.measure(options_, report);
      progress("");
      fmt::print("{}\n", table);
      std::fflush(stdout);
    }
  }

 private:
  const char* name_;
  const char* description_;
  std::span<const Part<Options>> parts_;
  Options options_;
};

}  // namespace bench
