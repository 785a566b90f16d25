#pragma once
// This finds the name to suggest in "did you mean", which is spelled most like the one given.

#include <optional>
#include <span>
#include <string_view>

namespace suture::compiler::model {

/// Returns the one of `known` that is made of `name` by changing the fewest letters; none if even
/// that is no slip. A slip changes at most two letters, or a third of them if that is more, and
/// never all. A name that is the beginning of the other is a slip too.
std::optional<std::string_view> nearest(std::string_view name,
                                        std::span<const std::string_view> known);

}  // namespace suture::compiler::model
