#pragma once
// These are two ends whose contracts differ in optional commands.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace suture {

/// Returns the numbers of the commands here that are not there, if the two self-descriptions (JSON)
/// differ only in optional commands behind those that they share. Returns none if they differ in
/// more.
std::optional<std::vector<std::uint16_t>> lackingOptional(std::string_view here,
                                                          std::string_view there);

}  // namespace suture
