#include "compiler/driver/diff.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <optional>

#include "compiler/driver/files.h"
#include "compiler/lock/differences.h"

namespace suture::compiler::driver {
namespace {

constexpr int kCompatible = 0, kBroken = 1, kNoAnswer = 2;

std::optional<lock::Lock> readLock(const std::string& path) {
  const std::optional<std::string> text = readText(path);
  if (!text) {
    std::cerr << "suturec diff: error: cannot read '" << path << "'\n";
    return std::nullopt;
  }
  model::Diagnostics problems;
  lock::Locks locks = lock::read({{path, *text}}, problems);
  for (const model::Diagnostic& problem : problems) {
    std::cerr << path << ":" << problem.source.line << ": error: " << problem.message << " [suture-"
              << problem.slug << "]\n";
  }
  if (!problems.empty()) return std::nullopt;
  return std::move(locks.files.begin()->second);
}

int tell(const std::vector<lock::Difference>& differences) {
  for (const lock::Difference& one : differences) std::cout << one.line() << "\n";
  const auto any = [&](lock::Effect effect) {
    return std::any_of(differences.begin(), differences.end(),
                       [effect](const lock::Difference& one) { return one.effect == effect; });
  };
  const bool broken = any(lock::Effect::Break);
  if (differences.empty()) {
    std::cout << "Nothing changed on the wire.\n";
  } else if (broken) {
    std::cout << "Peers and recordings of the old version do not work with the new one.\n";
  } else {
    std::cout << "Messages and recordings of the old version stay readable, and the other way "
                 "round"
              << (any(lock::Effect::Refusals) ? ", but for the values that are refused.\n" : ".\n");
  }
  return broken ? kBroken : kCompatible;
}

}  // namespace

int diff(std::vector<std::string> arguments) {
  CLI::App app{"Says what changed between two locked schemas, and whether old peers still work.",
               "suturec diff"};
  std::string old, now;
  app.add_option("old", old, "The schema of before")->required();
  app.add_option("new", now, "The schema of now")->required();
  try {
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants it
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kCompatible : kNoAnswer;
  }
  const std::optional<lock::Lock> before = readLock(old), after = readLock(now);
  return before && after ? tell(lock::differences(*before, *after)) : kNoAnswer;
}

}  // namespace suture::compiler::driver
