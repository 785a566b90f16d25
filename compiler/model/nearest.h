#pragma once
// This finds for "did you mean" the name that is spelled most like another.

#include <span>
#include <string_view>

namespace suture::compiler::model {

/// Returns the nearest of `known`, which must not be empty, by the number of letters to change.
std::string_view nearest(std::string_view name, std::span<const std::string_view> known);

}  // namespace suture::compiler::model
