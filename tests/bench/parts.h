#pragma once
// This is a subcommand that measures one thing after the other.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "bench/benchmark.h"
#include "bench/progress.h"

namespace bench {

template <class Options>
struct Part {
  const char* title;
  /// Returns its table.
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
  void addOptions(CLI::App& options) override {
    std::vector<std::string> titles;
    for (const Part<Options>& part : parts_) titles.emplace_back(part.title);
    auto* const only = options.add_option("--part", only_, "measures only this; may be repeated")
                           ->check(CLI::IsMember(titles));
    options.get_option("--check")->excludes(only);  // the others would fall short
    options_.addTo(options);
  }

  void run(Report& report) override {
    report.note("options", options_.toJson());
    for (const Part<Options>& part : parts_) {
      if (!isWanted(part)) continue;
      progress(part.title);
      const std::string table = part.measure(options_, report);
      progress("");
      fmt::print("{}\n", table);
      std::fflush(stdout);
    }
  }

 private:
  bool isWanted(const Part<Options>& part) const {
    return only_.empty() || std::find(only_.begin(), only_.end(), part.title) != only_.end();
  }

  const char* name_;
  const char* description_;
  std::span<const Part<Options>> parts_;
  Options options_;
  std::vector<std::string> only_;  // empty: all
};

}  // namespace bench
