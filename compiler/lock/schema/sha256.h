#pragma once
// These compute SHA-256 for ids and contract hashes.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace suture::compiler::lock {

std::array<std::uint8_t, 32> sha256(std::string_view text);

/// Returns the first `bytes` bytes in lower-case hexadecimal.
std::string sha256Hex(std::string_view text, unsigned bytes = 32);

}  // namespace suture::compiler::lock
