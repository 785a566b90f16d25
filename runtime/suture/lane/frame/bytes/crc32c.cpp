#include <isa-l/crc.h>
#include <suture/lane/frame/bytes/crc32c.h>

namespace suture::frame {

// The library leaves both inversions to its caller, and does not change the bytes.
std::uint32_t crc32c(std::span<const std::byte> bytes) {
  auto* const begin = reinterpret_cast<unsigned char*>(const_cast<std::byte*>(bytes.data()));
  return ~crc32_iscsi(begin, static_cast<int>(bytes.size()), ~0u);
}

}  // namespace suture::frame
