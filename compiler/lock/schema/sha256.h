#pragma once
// SHA-256 as ids and contract hashes have it.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace suture::compiler::lock {

std::array<std::uint8_t, 32> sha256(std::string_view text);

/// Lower-case hexadecimal of the first `bytes` bytes.
std::string sha256Hex(std::string_view text, unsigned bytes = 32);

}  // namespace suture::compiler::lock
