#pragma once
// The stress sends these: bytes that tell if they belong together.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace stress {

using Bytes = std::array<std::byte, 120>;  // a PoseSample's

inline std::span<std::byte> at(std::byte* memory, std::size_t size = sizeof(Bytes)) {
  return {memory, size};
}
inline std::span<const std::byte> at(const std::byte* memory, std::size_t size = sizeof(Bytes)) {
  return {memory, size};
}

/// Fills `memory`, of at least 16 bytes, with a serial number, bytes that follow from it, and a sum
/// over all.
void fill(std::span<std::byte> memory, std::uint64_t serial);

/// Returns the serial number; 0 if the bytes are not those of one fill().
std::uint64_t serialOf(std::span<const std::byte> memory);

}  // namespace stress
