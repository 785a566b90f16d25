#include "bench/figures/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace bench {
namespace {

constexpr std::size_t kGap = 2;

}  // namespace

std::vector<std::size_t> Table::widths() const {
  std::vector<std::size_t> widths;
  for (const auto& row : rows_) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  return widths;
}

std::string Table::toString() const {
  const auto width = widths();
  const std::size_t total = std::accumulate(width.begin(), width.end(), kGap * width.size()) - kGap;
  std::string text;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) line.append(kGap, ' ');
      line += i < leftColumns_ ? fmt::format("{:<{}}", row[i], width[i])
                               : fmt::format("{:>{}}", row[i], width[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += (row.empty() ? std::string(total, '-') : line) + "\n";
  }
  return text;
}

std::vector<std::string> statisticsTitles() {
  return {"mean", "std", "min", "p50", "p99", "p99.9", "max"};
}

std::vector<std::string> cellsOf(const Statistics& s, int digits) {
  std::vector<std::string> cells;
  for (const double value : {s.mean, s.std, s.min, s.p50, s.p99, s.p999, s.max}) {
    cells.push_back(number(value, digits));
  }
  return cells;
}

std::string number(double value, int digits) { return fmt::format("{:.{}f}", value, digits); }

std::vector<std::string> joined(std::vector<std::string> first,
                                const std::vector<std::string>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

}  // namespace bench
