#pragma once
// This answers "did you mean" with the closest of the names that exist.

#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// Set-up code only: allocates. Returns the candidate with the smallest edit distance to `name`, or
/// "" if none is within a third of its length (at least two edits).
std::string nearestName(std::string_view name, const std::vector<std::string>& candidates);

/// Returns "'a', 'b' and 'c'", or "none".
std::string listNames(const std::vector<std::string>& names);

/// Returns "interfaces 'a' and 'b'", or "no interfaces", for what somebody has.
std::string listNamed(const std::string& what, const std::vector<std::string>& names);

/// Returns what to do where `name` was asked for and only `names` exist.
std::string remedyForName(std::string_view name, const std::vector<std::string>& names);

}  // namespace suture
