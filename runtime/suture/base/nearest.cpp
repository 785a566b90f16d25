#include <suture/base/nearest.h>

#include <algorithm>
#include <numeric>

namespace suture {
namespace {

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

std::string nearestName(std::string_view name, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t bestDistance = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    // Each byte that one has more is an edit; a peer may ask for a name of megabytes.
    if (candidate.size() >= name.size() + bestDistance) continue;
    if (name.size() >= candidate.size() + bestDistance) continue;
    const std::size_t distance = editDistance(name, candidate);
    if (distance < bestDistance) {
      bestDistance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string listNames(const std::vector<std::string>& names) {
  if (names.empty()) return "none";
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
    text += "'" + names[i] + "'";
  }
  return text;
}

std::string listNamed(const std::string& what, const std::vector<std::string>& names) {
  return names.empty() ? "no " + what : what + " " + listNames(names);
}

std::string remedyForName(std::string_view name, const std::vector<std::string>& names) {
  if (names.empty()) return "Look whether another was meant";
  const std::string nearest = nearestName(name, names);
  return nearest.empty() ? "Use one of those names" : "Did you mean '" + nearest + "'?";
}

}  // namespace suture
