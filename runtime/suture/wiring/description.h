#pragma once
// This reads a contract's self-description, which a peer may have written.

#include <nlohmann/json.hpp>
#include <string_view>

namespace suture {

/// Returns the self-description, or a discarded value if the text is no JSON, is longer than 1 MiB,
/// or is nested more than 32 levels deep. No real one comes near that, and to compare one takes
/// time and stack.
nlohmann::json readDescription(std::string_view text);

}  // namespace suture
