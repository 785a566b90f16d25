#pragma once
// "Did you mean": the closest of the names that exist.

#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// The candidate with the smallest edit distance to `name`, or "" if none is within a third of its
/// length (at least two edits). Set-up code only: allocates.
std::string nearestName(std::string_view name, const std::vector<std::string>& candidates);

/// "'a', 'b' and 'c'", or "none".
std::string listNames(const std::vector<std::string>& names);

}  // namespace suture
