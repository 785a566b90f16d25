#pragma once
// The checksum of frames: CRC-32C (Castagnoli), as in iSCSI (RFC 3720) and ext4.

#include <cstddef>
#include <cstdint>
#include <span>

namespace suture::frame {

/// Any thread. By the processor's own instruction where it has one.
std::uint32_t crc32c(std::span<const std::byte> bytes);

/// The same without it.
std::uint32_t crc32cByTable(std::span<const std::byte> bytes);

}  // namespace suture::frame
