#include <fcntl.h>
#include <suture/base/errors.h>
#include <suture/lane/frame/frame_sockets.h>
#include <suture/loop/failure.h>
#include <sys/random.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace suture {
namespace {

class SocketServer final : public wire::FrameSocket::Server {
 public:
  explicit SocketServer(kj::AutoCloseFd socket) : socket_(kj::mv(socket)) {}
  kj::Maybe<int> getFd() override { return socket_.get(); }

 private:
  const kj::AutoCloseFd socket_;
};

/// Sends it in one go, since it comes first on a connection, which has room for so little.
bool say(rpc::ByteStream& bytes, const rpc::Token& token) {
  const auto opening = rpc::preambleOf(token);
  return bytes.send(opening, {}) == static_cast<ssize_t>(opening.size());
}

kj::Exception refused(const std::string& text) {
  return rpc::failure(kj::Exception::Type::FAILED, text);
}

template <class Value>
Value random() {
  Value value;
  fillWithRandom(&value, sizeof(value));
  return value;
}

bool isSame(const rpc::PeerIdentity& one, const rpc::PeerIdentity& other) {
  return one.proof == other.proof && one.user == other.user && one.process == other.process;
}

bool isSame(const FrameClient& one, const FrameClient& other) {
  return !one.name.empty() && one.name == other.name && isSame(one.who, other.who) &&
         one.handsOver == other.handsOver;
}

struct SocketPair {
  kj::AutoCloseFd ours, theirs;
};

SocketPair makeSockets() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, ends) == 0) {
    return {kj::AutoCloseFd(ends[0]), kj::AutoCloseFd(ends[1])};
  }
  throw SetupError("make sockets for a connection", std::strerror(errno),
                   "Raise the limit of descriptors (ulimit -n)");
}

}  // namespace

void fillWithRandom(void* memory, std::size_t size) {
  if (getrandom(memory, size, 0) == static_cast<ssize_t>(size)) return;
  throw SetupError("get random bytes for a connection", std::strerror(errno), "Try again");
}

bool FrameSockets::Shared::take(const std::shared_ptr<frame::Connection>& connection) {
  if (const auto held = link.lock()) {
    if (held->broken()) return false;
    held->join(connection);
    return true;
  }
  if (token == nullptr) return false;
  awaiting.push_back(connection);
  return true;
}

FrameSockets::Offered FrameSockets::offer(const UncarriedEnd& end, const FrameClient& client) {
  forgetEnded();
  Offered offered;
  offered.connection = ++latest_;
  const auto side = std::make_shared<frame::ProviderSide>(end.channel, offered.connection);
  if (end.readOnly) side->setReadOnly();
  for (auto& [epoch, shared] : links_) {
    if (!isSame(shared.client, client) || !shared.take(side)) continue;
    doorbell()->ring();
    offered.epoch = epoch;
    return offered;
  }
  makeLink(side, client, offered);
  return offered;
}

void FrameSockets::makeLink(const std::shared_ptr<frame::Connection>& first,
                            const FrameClient& client, Offered& offered) {
  offered.epoch = random<std::uint32_t>();
  Shared shared{.client = client, .link = {}, .token = nullptr, .awaiting = {first}};
  if (client.handsOver) {
    SocketPair pair = makeSockets();
    begin(offered.epoch, shared, rpc::ByteStream(kj::mv(pair.ours)));
    offered.socket = kj::heap<SocketServer>(kj::mv(pair.theirs));
  } else {
    const auto token = random<rpc::Token>();
    offered.token = token;
    shared.token = token;
  }
  links_.insert_or_assign(offered.epoch, std::move(shared));
}

void FrameSockets::begin(std::uint32_t epoch, Shared& shared, rpc::ByteStream bytes) {
  const auto link = std::make_shared<frame::Link>(kj::mv(bytes), epoch);
  for (auto& one : std::exchange(shared.awaiting, {})) link->join(std::move(one));
  shared.link = link;
  lane_.add(link);
}

void FrameSockets::arrived(const rpc::Token& token, rpc::ByteStream bytes) {
  for (auto& [epoch, shared] : links_) {
    KJ_IF_MAYBE (awaited, shared.token) {
      if (*awaited != token || !isSame(shared.client.who, bytes.peer())) continue;
      shared.token = nullptr;
      if (say(bytes, token)) begin(epoch, shared, kj::mv(bytes));
      return;
    }
  }
}

void FrameSockets::forgetEnded() {
  for (auto& [epoch, shared] : links_) {
    std::erase_if(shared.awaiting, [](const auto& end) { return end->over(); });
  }
  std::erase_if(links_, [](const auto& one) {
    const Shared& shared = one.second;
    const auto link = shared.link.lock();
    return (link == nullptr || link->broken()) && shared.awaiting.empty();
  });
}

kj::Promise<rpc::ByteStream> receiveSocket(wire::FrameSocket::Client socket) {
  return socket.getFd().then([socket](kj::Maybe<int> descriptor) -> kj::Promise<rpc::ByteStream> {
    KJ_IF_MAYBE (handle, descriptor) {
      const int own = fcntl(*handle, F_DUPFD_CLOEXEC, 0);
      if (own < 0) return refused(std::string("keep the socket: ") + std::strerror(errno));
      kj::AutoCloseFd kept(own);
      fcntl(kept, F_SETFL, fcntl(kept, F_GETFL) | O_NONBLOCK);
      return rpc::ByteStream(kj::mv(kept));
    }
    return refused("no socket came with the answer");
  });
}

kj::Promise<rpc::ByteStream> showToken(rpc::EventPort& port, rpc::ByteStream bytes,
                                       capnp::Data::Reader token) {
  rpc::Token own;
  if (token.size() != own.size()) return refused("the provider's token has an impossible size");
  std::memcpy(own.data(), token.begin(), own.size());
  if (!say(bytes, own)) return refused("the second connection takes nothing");
  return rpc::readPreamble(port, kj::mv(bytes), {})
      .then([own](rpc::Opened opened) -> kj::Promise<rpc::ByteStream> {
        KJ_IF_MAYBE (theirs, opened.token) {
          if (*theirs == own) return kj::mv(opened.bytes);
        }
        return refused("nobody awaits a second connection there");
      });
}

}  // namespace suture
