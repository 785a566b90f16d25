#pragma once
// This is the guard in front of Cap'n Proto: it looks at the header of a message before the
// library does.
//
// A message begins with the number of segments minus one and each segment's size in words, all
// 32-bit little endian, padded to whole words. Release 0.9.2 computes with them in 32 bits, so a
// hostile count wraps to zero and faults inside its reader (upstream advisory 2026-03-12-0). Here
// they are added in 64 bits and bounded, and a message that fails is never shown to the library.

#include <capnp/common.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace suture::framing {

/// Bounds what a peer may make us read and hold, and how long it may keep us waiting.
struct StreamLimits {
  std::uint32_t segments = 512;
  std::size_t messageBytes = 16u << 20;      ///< header and body of one message
  std::size_t unsentBytes = 64u << 20;       ///< written, and not yet taken by the peer
  std::size_t answerBytes = 64u << 20;       ///< answers to questions that the peer keeps open
  std::size_t strangerBytes = 16u << 10;     ///< each of these, for a peer that is not known yet
  std::uint32_t questions = 1u << 16;        ///< that a peer may ask at a time
  std::uint32_t strangerQuestions = 64;      ///< the same, for a peer that is not known yet
  std::int64_t drainMilliseconds = 10'000;   ///< at the end: until the peer has taken all
  std::int64_t partialMilliseconds = 5'000;  ///< from the first byte of a message to its last
  std::int64_t firstMilliseconds =
      5'000;  ///< from the connection to its first whole message; 0: no bound
  std::int64_t handshakeMilliseconds = 5'000;  ///< accepted links: for TLS
  std::int64_t helloMilliseconds = 10'000;     ///< accepted links: until the peer is known
};

/// Says where the parts of a message lie.
struct MessageHeader {
  std::uint32_t segments = 0;
  std::size_t headerBytes = 0;
  std::size_t totalBytes = 0;  ///< header and body
};

enum class HeaderFault : std::uint8_t { None, TooManySegments, TooLong };

struct HeaderParse {
  HeaderFault fault = HeaderFault::None;
  std::optional<MessageHeader> header;  ///< none: a fault, or not enough bytes yet
};

/// Reads the header at the start of `bytes`, of which any number may have arrived. Refuses as early
/// as possible: the count of segments may be enough.
HeaderParse parseMessageHeader(std::span<const std::byte> bytes, const StreamLimits& limits);

/// Returns the size in words of segment `index`, from a header that parseMessageHeader accepted.
std::uint32_t segmentWords(std::span<const std::byte> header, std::uint32_t index);

/// Returns the size of a message in the same format, header and body.
std::size_t bytesOfMessage(kj::ArrayPtr<const kj::ArrayPtr<const capnp::word>> segments);

/// Appends a message in the same format, ready to send.
void appendMessage(kj::ArrayPtr<const kj::ArrayPtr<const capnp::word>> segments,
                   std::vector<std::byte>& bytes);

/// Returns the fault in words; the text is static.
const char* toString(HeaderFault fault);

/// These say what to do about a peer that has let a deadline pass.
inline constexpr const char* kSentNothing =
    "see what the process at the other end says and does: it holds the connection open, and has "
    "sent nothing for seconds. It hangs, has been stopped, or has no file descriptor left";
inline constexpr const char* kFinishedNothing =
    "see what the process at the other end says and does: it began a message, and has not finished "
    "it for seconds. It hangs, has been stopped, or the network between the two is cut";

}  // namespace suture::framing
