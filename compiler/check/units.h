#pragma once
// These are the units that an annotation may give, spelled as in UCUM.

#include <optional>
#include <string>
#include <string_view>

namespace suture::compiler::check {

/// Returns true for products and quotients of known units, with SI prefixes and powers: "kg.m2/s".
bool isKnownUnit(std::string_view symbol);

/// Returns the unit in common use that `symbol`, which is no known one, is likely to mean, or none.
std::optional<std::string> nearestUnit(std::string_view symbol);

}  // namespace suture::compiler::check
