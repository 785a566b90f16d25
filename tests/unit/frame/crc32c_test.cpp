#include <gtest/gtest.h>
#include <suture/lane/frame/bytes/crc32c.h>

#include <random>
#include <string_view>
#include <vector>

namespace suture::frame {
namespace {

std::span<const std::byte> bytesOf(std::string_view text) { return std::as_bytes(std::span(text)); }

// The values are those of RFC 3720, B.4.
TEST(Crc32c, IsThatOfTheStandard) {
  const std::vector<std::byte> zeros(32), ones(32, std::byte{0xff});
  EXPECT_EQ(crc32c(zeros), 0x8a9136aau);
  EXPECT_EQ(crc32c(ones), 0x62a8ab43u);
  EXPECT_EQ(crc32c(bytesOf("123456789")), 0xe3069283u);
  EXPECT_EQ(crc32c({}), 0u);
}

/// Divides bit by bit.
std::uint32_t remainderOf(std::span<const std::byte> bytes) {
  std::uint32_t remainder = ~std::uint32_t{0};
  for (const std::byte byte : bytes) {
    remainder ^= std::to_integer<std::uint32_t>(byte);
    for (int bit = 0; bit < 8; ++bit) {
      remainder = (remainder >> 1) ^ ((remainder & 1) != 0 ? 0x82f63b78 : 0);
    }
  }
  return ~remainder;
}

TEST(Crc32c, DoesNotDependOnPlaceOrSize) {
  std::mt19937 random(1);
  std::vector<std::byte> bytes(300);
  for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
  for (std::size_t begin = 0; begin < 9; ++begin) {
    for (std::size_t size = 0; begin + size <= bytes.size(); ++size) {
      const auto part = std::span<const std::byte>(bytes).subspan(begin, size);
      ASSERT_EQ(crc32c(part), remainderOf(part)) << begin << " + " << size;
    }
  }
}

}  // namespace
}  // namespace suture::frame
