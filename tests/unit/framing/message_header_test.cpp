#include <gtest/gtest.h>
#include <suture/framing/message_header.h>

#include <cstring>

namespace suture::framing {
namespace {

std::vector<std::byte> header(std::initializer_list<std::uint32_t> words) {
  std::vector<std::byte> bytes(words.size() * 4);
  std::memcpy(bytes.data(), std::data(words), bytes.size());
  return bytes;
}

TEST(MessageHeader, NeedsTheWholeTable) {
  const auto bytes = header({1, 3, 4, 0});
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const auto parse = parseMessageHeader(std::span(bytes).first(size), {});
    EXPECT_EQ(parse.fault, HeaderFault::None) << size;
    EXPECT_FALSE(parse.header) << size;
  }
  const auto parse = parseMessageHeader(bytes, {});
  ASSERT_TRUE(parse.header);
  EXPECT_EQ(parse.header->segments, 2u);
  EXPECT_EQ(parse.header->headerBytes, 16u);
  EXPECT_EQ(parse.header->totalBytes, 16u + 7 * 8);
  EXPECT_EQ(segmentWords(bytes, 0), 3u);
  EXPECT_EQ(segmentWords(bytes, 1), 4u);
}

TEST(MessageHeader, RefusesACountThatWrapsToZero) {
  const auto bytes = header({0xffffffffu, 0, 0, 0});
  EXPECT_EQ(parseMessageHeader(bytes, {}).fault, HeaderFault::TooManySegments);
  EXPECT_EQ(parseMessageHeader(std::span(bytes).first(4), {}).fault, HeaderFault::TooManySegments);
}

TEST(MessageHeader, AcceptsTheLimitOfSegments) {
  std::vector<std::byte> bytes(std::size_t{8} * 257);
  const auto count = [&](std::uint32_t segments) {
    const std::uint32_t word = segments - 1;
    std::memcpy(bytes.data(), &word, sizeof(word));
    return parseMessageHeader(bytes, {});
  };
  EXPECT_TRUE(count(512).header);
  EXPECT_EQ(count(513).fault, HeaderFault::TooManySegments);
}

TEST(MessageHeader, AddsSizesWithoutWrapping) {
  // Eight segments have 2^29 words each: 2^32 words, zero in 32 bits.
  const std::uint32_t big = 1u << 29;
  const auto bytes = header({7, big, big, big, big, big, big, big, big, 0});
  EXPECT_EQ(parseMessageHeader(bytes, {}).fault, HeaderFault::TooLong);
}

TEST(MessageHeader, AcceptsTheLimitOfBytes) {
  StreamLimits limits;
  limits.messageBytes = 800;
  EXPECT_TRUE(parseMessageHeader(header({0, 99}), limits).header);
  EXPECT_EQ(parseMessageHeader(header({0, 100}), limits).fault, HeaderFault::TooLong);
}

}  // namespace
}  // namespace suture::framing
