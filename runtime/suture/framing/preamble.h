#pragma once
// The first bytes of a connection say what it is for: messages, or a lane that awaits it.

#include <suture/framing/message_header.h>
#include <suture/loop/event_port.h>
#include <suture/net/byte_stream.h>

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace suture::framing {

/// A Token is a secret that is valid for one connection, and says which of the awaited connections
/// this is.
using Token = std::array<std::byte, 16>;

/// A connection that begins with this is not a link; a token follows. No message can begin with it.
inline constexpr std::string_view kPreamble = "SUTFRAME";

/// Returns kPreamble and the token, as they are sent.
std::array<std::byte, sizeof(Token) + 8> preambleOf(const Token& token);

/// This is a connection whose beginning has been read.
struct Opened {
  net::ByteStream bytes;
  kj::Maybe<Token> token;
  /// Holds the bytes of a link's first message that have been read.
  std::vector<std::byte> begun;
};

/// The control thread. Reads as many bytes as are needed to tell what the connection is for;
/// descriptors that come with them are closed. Rejects if the peer sends nothing in time, or
/// leaves.
kj::Promise<Opened> readPreamble(loop::EventPort& port, net::ByteStream bytes,
                                 const StreamLimits& limits);

/// Sends the token, which must be the first thing on the connection. Returns false if the
/// connection does not take it.
bool sendToken(net::ByteStream& bytes, const Token& token);
/// The control thread. Sends the token, and waits until the peer sends the same. Rejects if the
/// peer does not await it.
kj::Promise<net::ByteStream> exchangeToken(loop::EventPort& port, net::ByteStream bytes,
                                           const Token& token);

}  // namespace suture::framing
