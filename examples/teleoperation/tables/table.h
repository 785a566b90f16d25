#pragma once
// This is text in columns.

#include <cstddef>
#include <string>
#include <vector>

namespace demo {

/// The first column is left-aligned, the others right-aligned.
class Table {
 public:
  explicit Table(std::vector<std::string> titles) : rows_{std::move(titles)} {}

  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  /// Removes each column but the first that has "-", or nothing, in all rows.
  void dropEmptyColumns();
  /// Returns one line for each row, the titles first.
  std::vector<std::string> lines() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace demo
