#pragma once
// These find what a deployment names, and tell what else it could have named.

#include <suture/base/nearest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace suture {

template <class Entry>
std::vector<std::string> namesOf(const std::vector<Entry>& entries) {
  std::vector<std::string> names;
  for (const Entry& entry : entries) names.push_back(entry.name);
  return names;
}

/// Returns the first entry of that name; nullptr: there is none.
template <class Entry>
const Entry* findNamed(const std::vector<Entry>& entries, std::string_view name) {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const Entry& entry) { return entry.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

/// Returns "; did you mean 'b'?" for the nearest of the names that exist; "" if none is near.
inline std::string suggestion(std::string_view name, const std::vector<std::string>& existing) {
  const std::string nearest = nearestName(name, existing);
  return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

}  // namespace suture
