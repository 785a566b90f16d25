#include "fault/byte_proxy.h"

#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <span>
#include <stdexcept>

namespace suture {
namespace {

constexpr std::size_t kChunk = 16384;
constexpr std::size_t kTrickle = 64;  // bytes each time
constexpr auto kTricklePause = std::chrono::milliseconds(2);
constexpr unsigned kFirstWords = 24;  // chunks: connecting takes fewer

bool isDue(Time due) { return due <= now(); }

bool wouldBlock() { return errno == EAGAIN || errno == EINTR; }

int connectTo(const net::Address& target) {
  const net::SocketAddress address(target);
  const int to = socket(address.family(), SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (to >= 0 && connect(to, address.get(), address.length) == 0 &&
      fcntl(to, F_SETFL, O_NONBLOCK) == 0) {
    return to;
  }
  if (to >= 0) ::close(to);
  return -1;
}

std::string tcpAddressOf(int listener) {
  sockaddr_in bound{};
  socklen_t length = sizeof(bound);
  getsockname(listener, reinterpret_cast<sockaddr*>(&bound), &length);
  return "tcp://127.0.0.1:" + std::to_string(ntohs(bound.sin_port));
}

}  // namespace

ByteProxy::ByteProxy(const net::Address& here, const net::Address& target, unsigned seed)
    : target_(target), random_(seed), bell_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
  const net::SocketAddress wanted(here);
  listener_ = socket(wanted.family(), SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (bind(listener_, wanted.get(), wanted.length) != 0 || listen(listener_, 128) != 0) {
    throw std::runtime_error("the proxy cannot listen");
  }
  address_ = here.kind == net::Address::Kind::Unix ? here.text() : tcpAddressOf(listener_);
  thread_ = std::thread([this] { run(); });
}

ByteProxy::~ByteProxy() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  wake();
  thread_.join();
  closeAll(false);
  ::close(listener_);
  ::close(bell_);
}

void ByteProxy::wake() {
  const std::uint64_t one = 1;
  (void)!write(bell_, &one, sizeof(one));
}

void ByteProxy::set(Mode mode) {
  {
    const std::lock_guard lock(mutex_);
    mode_ = mode;
    for (Link& link : links_) link.held = link.stranded = false;
  }
  wake();
}

void ByteProxy::delay(Duration each) {
  {
    const std::lock_guard lock(mutex_);
    delay_ = each;
  }
  wake();
}

void ByteProxy::strike(Strike strike) {
  const std::lock_guard lock(mutex_);
  switch (strike) {
    case Strike::Strand:
      for (Link& link : links_) link.stranded = link.endless = true;
      injected_ += links_.size();
      return;
    case Strike::Cut: return closeAll(false);
    case Strike::Reset: return closeAll(true);
    case Strike::Truncate: truncates_ = true; return;
    case Strike::BitFlip: flips_ = true; return;
  }
}

// It does not look at what is held: the end of that would be reported again and again.
void ByteProxy::run() {
  std::vector<pollfd> waiting;
  for (;;) {
    waiting = {{listener_, POLLIN, 0}, {bell_, POLLIN, 0}};
    bool throttled = false;
    Time next = Time::max();
    {
      const std::lock_guard lock(mutex_);
      if (stopping_) return;
      throttled = mode_ == Mode::Throttle;
      for (Link& link : links_) {
        if (link.stranded) continue;
        for (const bool there : {true, false}) {
          Stream& stream = there ? link.there : link.back;
          if (!passes(stream, there)) continue;
          if (mayTake(stream)) waiting.push_back({stream.from, POLLIN, 0});
          if (stream.waiting.empty()) continue;
          const Time due = stream.waiting.front().due;
          isDue(due) ? waiting.push_back({stream.to, POLLOUT, 0})
                     : void(next = std::min(next, due));
        }
      }
    }
    const auto pause = std::chrono::ceil<std::chrono::milliseconds>(next - now());
    poll(waiting.data(), waiting.size(),
         next == Time::max() ? -1 : static_cast<int>(pause.count()));
    std::uint64_t rings;
    (void)!read(bell_, &rings, sizeof(rings));
    if (throttled) std::this_thread::sleep_for(kTricklePause);
    const std::lock_guard lock(mutex_);
    accept();
    std::erase_if(links_, [this](Link& link) {
      if (serve(link)) return false;
      close(link, false);
      return true;
    });
  }
}

// Without a delay the sender feels it when the receiver does not take what it sends.
bool ByteProxy::mayTake(const Stream& stream) const {
  return stream.waiting.empty() || delay_ > Duration{0};
}

bool ByteProxy::passes(const Stream& stream, bool there) const {
  if (stream.ended || mode_ == Mode::HalfOpen) return false;
  return mode_ != (there ? Mode::OnlyBack : Mode::OnlyThere);
}

void ByteProxy::accept() {
  for (;;) {
    const int from = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (from < 0) return;
    const int to = connectTo(target_);
    if (to < 0) {
      ::close(from);
      continue;
    }
    const int on = 1;
    setsockopt(from, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
    setsockopt(to, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
    Link& link = links_.emplace_back();
    link.there.from = link.back.to = from;
    link.there.to = link.back.from = to;
  }
}

/// Returns false when it is over.
bool ByteProxy::serve(Link& link) {
  if (link.stranded) return true;
  if (mode_ != Mode::Forward && !std::exchange(link.held, true)) ++injected_;
  for (const bool there : {true, false}) {
    Stream& stream = there ? link.there : link.back;
    if (!passes(stream, there)) continue;
    if ((mayTake(stream) && !take(link, there)) || !give(stream)) stream.ended = true;
  }
  return link.endless || (!link.there.ended && !link.back.ended);
}

bool ByteProxy::take(Link& link, bool there) {
  Stream& stream = there ? link.there : link.back;
  std::array<std::byte, kChunk> bytes;
  const std::size_t most = mode_ == Mode::Throttle ? kTrickle : bytes.size();
  Chunk chunk;
  const ssize_t count =
      net::receiveWith(stream.from, std::span(bytes).first(most), chunk.descriptors);
  if (count < 0) return wouldBlock();
  if (count == 0) {
    stream.ended = true;
    return true;
  }
  chunk.due = now() + delay_;
  chunk.bytes.assign(bytes.begin(), bytes.begin() + count);
  stream.waiting.push_back(std::move(chunk));
  ++link.said;
  hurt(link, there);
  return true;
}

void ByteProxy::hurt(Link& link, bool there) {
  Stream& stream = there ? link.there : link.back;
  std::vector<std::byte>& bytes = stream.waiting.back().bytes;
  if (link.said > kFirstWords && std::exchange(flips_, false)) {
    const auto bit = std::uniform_int_distribution<std::size_t>(0, 8 * bytes.size() - 1)(random_);
    bytes[bit / 8] ^= std::byte{1} << bit % 8;
    ++injected_;
  }
  if (there && std::exchange(truncates_, false)) {
    bytes.resize(bytes.size() / 2);
    stream.ended = true;
    ++injected_;
  }
}

bool ByteProxy::give(Stream& stream) {
  while (!stream.waiting.empty() && isDue(stream.waiting.front().due)) {
    auto& [due, bytes, descriptors] = stream.waiting.front();
    const ssize_t count = net::sendWith(stream.to, bytes, descriptors);
    if (count < 0) return wouldBlock();
    descriptors.clear();
    bytes.erase(bytes.begin(), bytes.begin() + count);
    if (!bytes.empty()) return true;
    stream.waiting.pop_front();
  }
  return true;
}

void ByteProxy::closeAll(bool reset) {
  for (Link& link : links_) {
    close(link, reset);
    ++injected_;
  }
  links_.clear();
}

void ByteProxy::close(Link& link, bool reset) {
  const linger atOnce{1, 0};
  for (const int socket : {link.there.from, link.there.to}) {
    if (reset) setsockopt(socket, SOL_SOCKET, SO_LINGER, &atOnce, sizeof(atOnce));
    ::close(socket);
  }
}

}  // namespace suture
