#pragma once
// Two ends whose contracts differ in optional commands.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace suture {

/// The numbers of the commands here that are not there, if the two self-descriptions (JSON) differ
/// in nothing but optional commands behind those that they share. None if they differ in more.
std::optional<std::vector<std::uint16_t>> lackingOptional(std::string_view here,
                                                          std::string_view there);

}  // namespace suture
