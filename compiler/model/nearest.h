#pragma once
// This finds the name to suggest in "did you mean", which is spelled most like the one given.

#include <span>
#include <string_view>

namespace suture::compiler::model {

/// Returns the one of `known`, which must not be empty, that `name` becomes by the fewest changed
/// letters.
std::string_view nearest(std::string_view name, std::span<const std::string_view> known);

}  // namespace suture::compiler::model
