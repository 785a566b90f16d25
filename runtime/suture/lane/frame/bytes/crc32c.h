#pragma once
// This is the checksum of frames: CRC-32C (Castagnoli), as in iSCSI (RFC 3720) and ext4.

#include <cstddef>
#include <cstdint>
#include <span>

namespace suture::frame {

/// Any thread. It is as fast as the processor's instructions allow.
std::uint32_t crc32c(std::span<const std::byte> bytes);

}  // namespace suture::frame
