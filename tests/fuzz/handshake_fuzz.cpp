// This fuzzes what a peer says first: the opening of a second connection, with its token, or the
// messages of a link. The bytes come in any pieces, and then no more come.

#include <suture/framing/message_stream.h>
#include <suture/framing/preamble.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "tests/fuzz/input.h"
#include "tests/fuzz/require.h"

namespace {

using namespace suture;
using suture::fuzz::Input;
using suture::fuzz::require;

constexpr framing::StreamLimits kLimits{.segments = 16, .messageBytes = 4096};

class Peer {
 public:
  explicit Peer(std::vector<std::byte> bytes) : bytes_(std::move(bytes)) {
    int ends[2];
    require(socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends) == 0);
    ours_ = kj::AutoCloseFd(ends[0]);
    theirs_ = kj::AutoCloseFd(ends[1]);
  }

  kj::AutoCloseFd connect() { return kj::mv(ours_); }
  void say(std::size_t count) {
    const std::size_t part = std::min(count, bytes_.size() - said_);
    if (part == 0) return;
    require(send(theirs_, bytes_.data() + said_, part, MSG_NOSIGNAL) == static_cast<ssize_t>(part));
    said_ += part;
  }
  void sayNoMore() { shutdown(theirs_, SHUT_WR); }

 private:
  const std::vector<std::byte> bytes_;
  std::size_t said_ = 0;
  kj::AutoCloseFd ours_, theirs_;
};

/// Returns a beginning that is often as it should be, so that what comes behind is reached.
std::vector<std::byte> beginning(Input& input) {
  std::vector<std::byte> bytes;
  switch (input.byte() % 4) {
    case 0: {
      framing::Token token{};
      token[0] = static_cast<std::byte>(input.byte());
      const auto opening = framing::preambleOf(token);
      bytes.assign(opening.begin(), opening.end());
      break;
    }
    case 1: {
      const std::array<capnp::word, 2> segment{};
      const kj::ArrayPtr<const capnp::word> segments[] = {
          kj::arrayPtr(segment.data(), input.byte() % 3), kj::arrayPtr(segment.data(), 1)};
      framing::appendMessage(kj::arrayPtr(segments, 1 + input.byte() % 2), bytes);
      break;
    }
    default: break;
  }
  return bytes;
}

bool beginsWith(const std::vector<std::byte>& bytes, const void* start, std::size_t size) {
  return bytes.size() >= size && (size == 0 || std::memcmp(bytes.data(), start, size) == 0);
}

/// Reads all of its messages, as far as they go.
void readMessages(loop::EventPort& port, net::ByteStream stream,
                  const std::vector<std::byte>& begun) {
  framing::MessageStream messages(port, kj::mv(stream), kLimits, begun);
  for (;;) {
    auto next = messages.read().wait(port.scope());
    KJ_IF_MAYBE (message, next) {
      require((*message)->sizeInWords() * sizeof(capnp::word) <= kLimits.messageBytes);
      KJ_IF_MAYBE (broken, kj::runCatchingExceptions([&] { (*message)->getBody().targetSize(); })) {
        (void)broken;
      }
    } else {
      return;
    }
  }
}

void listen(const std::vector<std::byte>& bytes, std::size_t first) {
  loop::EventPort port;
  Peer peer(bytes);
  auto opening = framing::readPreamble(port, net::ByteStream(peer.connect()), kLimits);
  peer.say(first);
  opening.poll(port.scope());
  peer.say(bytes.size());
  peer.sayNoMore();
  framing::Opened opened = opening.wait(port.scope());
  KJ_IF_MAYBE (token, opened.token) {
    require(
        beginsWith(bytes, framing::preambleOf(*token).data(), framing::preambleOf(*token).size()));
  } else {
    require(beginsWith(bytes, opened.begun.data(), opened.begun.size()));
    readMessages(port, kj::mv(opened.bytes), opened.begun);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input(data, size);
  const std::size_t first = input.byte();
  std::vector<std::byte> bytes = beginning(input);
  while (!input.ended()) bytes.push_back(static_cast<std::byte>(input.byte()));
  // A refused peer is an exception.
  KJ_IF_MAYBE (refused, kj::runCatchingExceptions([&] { listen(bytes, first); })) {
    (void)refused;
  }
  return 0;
}
