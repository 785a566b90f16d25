#include <suture/framing/message_header.h>

#include <cstring>

namespace suture::framing {
namespace {

constexpr std::size_t kWord = 8;

std::uint32_t wordAt(std::span<const std::byte> bytes, std::size_t index) {
  std::uint32_t value;
  std::memcpy(&value, bytes.data() + index * sizeof(value), sizeof(value));
  return value;  // little endian, like the machines that Cap'n Proto's zero-copy assumes
}

constexpr std::size_t bytesOfHeader(std::uint64_t segments) { return (segments / 2 + 1) * kWord; }

}  // namespace

HeaderParse parseMessageHeader(std::span<const std::byte> bytes, const StreamLimits& limits) {
  if (bytes.size() < sizeof(std::uint32_t)) return {};
  const std::uint64_t segments = std::uint64_t{wordAt(bytes, 0)} + 1;
  if (segments > limits.segments) return {HeaderFault::TooManySegments, {}};
  const std::size_t headerBytes = bytesOfHeader(segments);
  if (bytes.size() < headerBytes) return {};

  std::uint64_t total = headerBytes;
  for (std::size_t i = 1; i <= segments; ++i) total += std::uint64_t{wordAt(bytes, i)} * kWord;
  if (total > limits.messageBytes) return {HeaderFault::TooLong, {}};
  return {HeaderFault::None,
          MessageHeader{static_cast<std::uint32_t>(segments), headerBytes, total}};
}

std::uint32_t segmentWords(std::span<const std::byte> header, std::uint32_t index) {
  return wordAt(header, std::size_t{index} + 1);
}

std::size_t bytesOfMessage(kj::ArrayPtr<const kj::ArrayPtr<const capnp::word>> segments) {
  std::size_t bytes = bytesOfHeader(segments.size());
  for (const auto& segment : segments) bytes += segment.size() * kWord;
  return bytes;
}

void appendMessage(kj::ArrayPtr<const kj::ArrayPtr<const capnp::word>> segments,
                   std::vector<std::byte>& bytes) {
  const auto count = static_cast<std::uint32_t>(segments.size());
  const std::size_t begin = bytes.size();
  bytes.resize(begin + bytesOfHeader(count));
  std::byte* header = bytes.data() + begin;
  const auto putSize = [header](std::size_t position, std::size_t value) {
    const auto size = static_cast<std::uint32_t>(value);
    std::memcpy(header + position * sizeof(size), &size, sizeof(size));
  };
  putSize(0, count - 1);
  for (std::uint32_t i = 0; i < count; ++i) putSize(i + 1, segments[i].size());
  for (const auto& segment : segments) {
    const auto* from = reinterpret_cast<const std::byte*>(segment.begin());
    bytes.insert(bytes.end(), from, from + segment.size() * kWord);
  }
}

const char* toString(HeaderFault fault) {
  switch (fault) {
    case HeaderFault::None: return "no fault";
    case HeaderFault::TooManySegments:
      return "a message header announces more segments than a message may have";
    case HeaderFault::TooLong: return "a message header announces a message longer than the limit";
  }
  return "unknown fault";
}

}  // namespace suture::framing
