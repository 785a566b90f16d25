#include "bench/figures/bounds.h"

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>

namespace bench {
namespace {

Bound parseLine(const std::string& line, int number) {
  const auto fail = [&](const char* problem) {
    return std::runtime_error(fmt::format(
        "line {} of the bounds: {}: '{}'. Write <subcommand>.<figure> <= <number> <unit> | <words>",
        number, problem, line));
  };
  const auto bar = line.find('|');
  if (bar == std::string::npos) throw fail("no '|' before the words");
  std::istringstream in(line.substr(0, bar));
  std::string name, comparison, rest;
  Bound bound;
  if (!(in >> name >> comparison >> bound.limit >> bound.unit)) throw fail("something is missing");
  if (in >> rest) throw fail("too much before the '|'");
  if (comparison != "<=" && comparison != ">=") throw fail("neither <= nor >=");
  bound.atMost = comparison == "<=";
  const auto dot = name.find('.');
  if (dot == std::string::npos) throw fail("no figure after the subcommand");
  bound.subcommand = name.substr(0, dot);
  bound.figure = name.substr(dot + 1);
  const auto words = line.find_first_not_of(' ', bar + 1);
  if (words == std::string::npos) throw fail("no words");
  bound.words = line.substr(words);
  return bound;
}

std::string judge(const Bound& bound, const Report& report) {
  const auto found = report.find(bound.figure);
  if (!found) {
    const std::string why = report.whyUnavailable(bound.figure);
    return why.empty() ? "not measured" : "not available: " + why.substr(0, why.find('\n'));
  }
  if (found->unit != bound.unit) {
    return fmt::format("measured in {}, bounded in {}", found->unit, bound.unit);
  }
  const bool kept = bound.atMost ? found->value <= bound.limit : found->value >= bound.limit;
  return kept ? "" : fmt::format("{:.1f} {}", found->value, found->unit);
}

}  // namespace

std::vector<Bound> parseBounds(std::string_view text) {
  std::vector<Bound> bounds;
  std::istringstream in{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.empty() || line.front() == '#') continue;
    bounds.push_back(parseLine(line, number));
  }
  return bounds;
}

std::vector<std::string> shortfalls(const std::vector<Bound>& bounds, const std::string& subcommand,
                                    const Report& report) {
  std::vector<std::string> lines;
  for (const Bound& bound : bounds) {
    if (bound.subcommand != subcommand) continue;
    const std::string problem = judge(bound, report);
    if (problem.empty()) continue;
    lines.push_back(fmt::format("{}: {}, must be {} {} {} ({})", bound.figure, problem,
                                bound.atMost ? "<=" : ">=", bound.limit, bound.unit, bound.words));
  }
  return lines;
}

}  // namespace bench
