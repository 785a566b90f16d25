#pragma once
// The closed table of units.

#include <string>
#include <string_view>

namespace suture::compiler::check {

bool isKnownUnit(std::string_view symbol);

/// The known unit that is spelled most like it.
std::string nearestUnit(std::string_view symbol);

}  // namespace suture::compiler::check
