#include "tables/table.h"

#include <fmt/format.h>

#include <algorithm>

namespace demo {

void Table::dropEmptyColumns() {
  for (std::size_t i = rows_.front().size() - 1; i > 0; --i) {
    const bool empty = std::all_of(rows_.begin() + 1, rows_.end(), [i](const auto& row) {
      return row[i].empty() || row[i] == "-";
    });
    if (!empty) continue;
    for (auto& row : rows_) row.erase(row.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

std::vector<std::string> Table::lines() const {
  std::vector<std::size_t> widths(rows_.front().size());
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::vector<std::string> lines;
  for (const auto& row : rows_) {
    std::string line = fmt::format("{:<{}}", row[0], widths[0]);
    for (std::size_t i = 1; i < row.size(); ++i) line += fmt::format("  {:>{}}", row[i], widths[i]);
    lines.push_back(line.substr(0, line.find_last_not_of(' ') + 1));
  }
  return lines;
}

}  // namespace demo
