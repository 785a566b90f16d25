#pragma once
// This finds the name to suggest in "did you mean", which is spelled most like the one given.

#include <optional>
#include <span>
#include <string_view>

namespace suture::compiler::model {

/// Returns the nearest of `known` by the number of letters to change, or none if no slip explains
/// the difference. Up to a third of the letters are slips, or two, but never all; and either name
/// may be the other one cut off.
std::optional<std::string_view> nearest(std::string_view name,
                                        std::span<const std::string_view> known);

}  // namespace suture::compiler::model
