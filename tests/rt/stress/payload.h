#pragma once
// What the stress sends: bytes that tell whether they belong together.

#include <cstddef>
#include <cstdint>
#include <span>

namespace stress {

/// Fills `memory`, of at least 16 bytes, with a serial number, bytes that follow from it, and a sum
/// over all.
void fill(std::span<std::byte> memory, std::uint64_t serial);

/// The serial number; 0 if the bytes are not those of one fill().
std::uint64_t serialOf(std::span<const std::byte> memory);

}  // namespace stress
