#include "compiler/lock/schema/sha256.h"

#include <openssl/sha.h>

namespace suture::compiler::lock {

std::array<std::uint8_t, 32> sha256(std::string_view text) {
  std::array<std::uint8_t, SHA256_DIGEST_LENGTH> digest{};
  SHA256(reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.data());
  return digest;
}

std::string sha256Hex(std::string_view text, unsigned bytes) {
  static constexpr char kDigits[] = "0123456789abcdef";
  const auto digest = sha256(text);
  std::string hex;
  for (std::size_t i = 0; i < bytes && i < digest.size(); ++i) {
    hex += kDigits[digest[i] >> 4];
    hex += kDigits[digest[i] & 15];
  }
  return hex;
}

}  // namespace suture::compiler::lock
