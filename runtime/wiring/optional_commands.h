#pragma once
// Two ends whose contracts differ in optional commands.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

namespace suture {

/// More commands than any contract has.
inline constexpr std::size_t kAllCommands = std::numeric_limits<std::uint16_t>::max();

/// How many commands the two self-descriptions (JSON) have in common, from the first, if they
/// differ in nothing but optional commands behind those. None if they differ in more.
std::optional<std::size_t> commonCommands(std::string_view here, std::string_view there);

}  // namespace suture
