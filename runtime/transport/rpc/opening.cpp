#include <suture/transport/rpc/failure.h>
#include <suture/transport/rpc/opening.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <span>

namespace suture::rpc {
namespace {

class OpeningReader {
 public:
  OpeningReader(EventPort& port, ByteStream bytes)
      : bytes_(kj::mv(bytes)),
        observer_(kj::heap<EventPort::FdObserver>(port, bytes_.socket(),
                                                  EventPort::FdObserver::OBSERVE_READ)) {}

  kj::Promise<Opened> read() {
    while (isOpening() && read_ < beginning_.size()) {
      Descriptors none;
      const ssize_t count = bytes_.receive(std::span(beginning_).subspan(read_), none);
      if (count > 0) {
        read_ += static_cast<std::size_t>(count);
      } else if (count == 0) {
        break;  // whoever serves a link finds that out
      } else if (errno == EAGAIN) {
        return observer_->whenBecomesReadable().then([this] { return read(); });
      } else if (errno != EINTR) {
        return bytes_.lost(errno);
      }
    }
    observer_ = nullptr;  // whoever reads next has one of its own
    return opened();
  }

 private:
  /// True if it is an opening, as far as it has come.
  bool isOpening() const {
    return std::memcmp(beginning_.data(), kOpening.data(), std::min(read_, kOpening.size())) == 0;
  }

  Opened opened() {
    if (!isOpening() || read_ < beginning_.size()) {
      return {kj::mv(bytes_), nullptr, {beginning_.begin(), beginning_.begin() + read_}};
    }
    Token token;
    std::copy(beginning_.begin() + kOpening.size(), beginning_.end(), token.begin());
    return {kj::mv(bytes_), token, {}};
  }

  ByteStream bytes_;
  kj::Own<EventPort::FdObserver> observer_;
  std::array<std::byte, sizeof(Token) + kOpening.size()> beginning_{};
  std::size_t read_ = 0;
};

}  // namespace

std::array<std::byte, sizeof(Token) + 8> openingOf(const Token& token) {
  std::array<std::byte, sizeof(Token) + 8> opening;
  static_assert(kOpening.size() == 8);
  std::memcpy(opening.data(), kOpening.data(), kOpening.size());
  std::copy(token.begin(), token.end(), opening.begin() + kOpening.size());
  return opening;
}

kj::Promise<Opened> readOpening(EventPort& port, ByteStream bytes, const StreamLimits& limits) {
  auto reader = kj::heap<OpeningReader>(port, kj::mv(bytes));
  auto opened = kj::evalNow([&] { return reader->read(); }).attach(kj::mv(reader));
  if (limits.firstMilliseconds == 0) return opened;
  auto late = port.getTimer()
                  .afterDelay(limits.firstMilliseconds * kj::MILLISECONDS)
                  .then([]() -> kj::Promise<Opened> {
                    return disconnected("the peer sent no message in time");
                  });
  return opened.exclusiveJoin(kj::mv(late));
}

}  // namespace suture::rpc
