#include <suture/framing/preamble.h>
#include <suture/loop/deadline.h>
#include <suture/loop/failure.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <span>

namespace suture::framing {
namespace {

class PreambleReader {
 public:
  PreambleReader(loop::EventPort& port, net::ByteStream bytes)
      : bytes_(kj::mv(bytes)),
        observer_(kj::heap<loop::EventPort::FdObserver>(
            port, bytes_.socket(), loop::EventPort::FdObserver::OBSERVE_READ)) {}

  kj::Promise<Opened> read() {
    while (isPreamble() && read_ < beginning_.size()) {
      net::Descriptors none;
      const ssize_t count = bytes_.receive(std::span(beginning_).subspan(read_), none);
      if (count > 0) {
        read_ += static_cast<std::size_t>(count);
      } else if (count == 0) {
        break;  // the code that serves the link finds that out
      } else if (errno == EAGAIN) {
        return observer_->whenBecomesReadable().then([this] { return read(); });
      } else if (errno != EINTR) {
        return bytes_.lost(errno);
      }
    }
    observer_ = nullptr;  // the next reader makes its own
    return opened();
  }

 private:
  /// Returns true if the bytes that have come can begin a preamble.
  bool isPreamble() const {
    return std::memcmp(beginning_.data(), kPreamble.data(), std::min(read_, kPreamble.size())) == 0;
  }

  Opened opened() {
    if (!isPreamble() || read_ < beginning_.size()) {
      return {kj::mv(bytes_), nullptr, {beginning_.begin(), beginning_.begin() + read_}};
    }
    Token token;
    std::copy(beginning_.begin() + kPreamble.size(), beginning_.end(), token.begin());
    return {kj::mv(bytes_), token, {}};
  }

  net::ByteStream bytes_;
  kj::Own<loop::EventPort::FdObserver> observer_;
  std::array<std::byte, sizeof(Token) + kPreamble.size()> beginning_{};
  std::size_t read_ = 0;
};

}  // namespace

std::array<std::byte, sizeof(Token) + 8> preambleOf(const Token& token) {
  std::array<std::byte, sizeof(Token) + 8> preamble;
  static_assert(kPreamble.size() == 8);
  std::memcpy(preamble.data(), kPreamble.data(), kPreamble.size());
  std::copy(token.begin(), token.end(), preamble.begin() + kPreamble.size());
  return preamble;
}

kj::Promise<Opened> readPreamble(loop::EventPort& port, net::ByteStream bytes,
                                 const StreamLimits& limits) {
  auto reader = kj::heap<PreambleReader>(port, kj::mv(bytes));
  auto opened = kj::evalNow([&] { return reader->read(); }).attach(kj::mv(reader));
  if (limits.firstMilliseconds == 0) return opened;
  return loop::unlessLate(port.getTimer(), std::chrono::milliseconds(limits.firstMilliseconds),
                          kj::mv(opened),
                          []() -> kj::Promise<Opened> { return loop::disconnected(kSentNothing); });
}

// A new connection has room for these few bytes, so they leave in one send.
bool sendToken(net::ByteStream& bytes, const Token& token) {
  const auto preamble = preambleOf(token);
  return bytes.send(preamble, {}) == static_cast<ssize_t>(preamble.size());
}

kj::Promise<net::ByteStream> exchangeToken(loop::EventPort& port, net::ByteStream bytes,
                                           const Token& token) {
  if (!sendToken(bytes, token)) {
    return loop::failure(kj::Exception::Type::FAILED, "the second connection takes nothing");
  }
  return readPreamble(port, kj::mv(bytes), {})
      .then([token](Opened opened) -> kj::Promise<net::ByteStream> {
        KJ_IF_MAYBE (theirs, opened.token) {
          if (*theirs == token) return kj::mv(opened.bytes);
        }
        return loop::failure(kj::Exception::Type::FAILED,
                             "nobody awaits a second connection there");
      });
}

}  // namespace suture::framing
