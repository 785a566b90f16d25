#pragma once
// What a connection is for, as its first bytes tell: messages, or somebody who awaits it.

#include <suture/framing/frame_header.h>
#include <suture/loop/event_port.h>
#include <suture/net/byte_stream.h>

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace suture::rpc {

/// A secret that is good for one connection, and says which of those that await one is meant.
using Token = std::array<std::byte, 16>;

/// A connection that begins so is no link: a token follows. No message can begin with it.
inline constexpr std::string_view kPreamble = "SUTFRAME";

/// kPreamble and the token, as they are sent.
std::array<std::byte, sizeof(Token) + 8> preambleOf(const Token& token);

/// A connection whose beginning has been read.
struct Opened {
  ByteStream bytes;
  kj::Maybe<Token> token;
  /// The bytes of a link's first message that have been read.
  std::vector<std::byte> begun;
};

/// Control thread: reads as far as that needs; descriptors that come with so few bytes are closed.
/// Rejects if the peer says nothing in time, or leaves.
kj::Promise<Opened> readPreamble(EventPort& port, ByteStream bytes, const StreamLimits& limits);

/// Says what the connection is for, which must be the first on it; false if it takes nothing.
bool sendToken(ByteStream& bytes, const Token& token);
/// Control thread: says it, and waits until the peer says the same. Rejects if that does not await
/// it.
kj::Promise<ByteStream> exchangeToken(EventPort& port, ByteStream bytes, const Token& token);

}  // namespace suture::rpc
