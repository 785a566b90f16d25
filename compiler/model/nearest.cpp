#include "compiler/model/nearest.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace suture::compiler::model {
namespace {

std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0u);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substituted, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

bool isLikely(std::string_view name, std::string_view known, std::size_t changes) {
  if (changes == std::max(name.size(), known.size())) return false;
  const bool isCut = name.starts_with(known) || known.starts_with(name);
  return isCut || changes <= std::max<std::size_t>(2, name.size() / 3);
}

}  // namespace

std::optional<std::string_view> nearest(std::string_view name,
                                        std::span<const std::string_view> known) {
  std::optional<std::string_view> best;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (const std::string_view one : known) {
    const std::size_t changes = distance(name, one);
    if (changes >= fewest || !isLikely(name, one, changes)) continue;
    fewest = changes;
    best = one;
  }
  return best;
}

}  // namespace suture::compiler::model
