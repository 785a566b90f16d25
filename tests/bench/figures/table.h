#pragma once
// These are aligned tables on a terminal.

#include <string>
#include <vector>

#include "bench/figures/statistics.h"

namespace bench {

/// Rows of cells; the first `leftColumns` columns are words and stand left, the others are numbers
/// and stand right.
class Table {
 public:
  explicit Table(std::size_t leftColumns) : leftColumns_(leftColumns) {}

  void row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  /// Adds a horizontal line.
  void line() { rows_.emplace_back(); }
  std::string toString() const;

 private:
  std::vector<std::size_t> widths() const;

  std::size_t leftColumns_;
  std::vector<std::vector<std::string>> rows_;
};

/// Returns the titles that belong to cellsOf().
std::vector<std::string> statisticsTitles();
/// Returns mean, std, min, p50, p99, p99.9, max, with so many digits after the point.
std::vector<std::string> cellsOf(const Statistics& statistics, int digits);
std::string number(double value, int digits);

std::vector<std::string> joined(std::vector<std::string> first,
                                const std::vector<std::string>& second);

}  // namespace bench
