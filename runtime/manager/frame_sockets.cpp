#include <fcntl.h>
#include <suture/base/errors.h>
#include <suture/manager/frame_sockets.h>
#include <suture/transport/rpc/failure.h>
#include <sys/random.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>

namespace suture {
namespace {

class SocketServer final : public wire::FrameSocket::Server {
 public:
  explicit SocketServer(kj::AutoCloseFd socket) : socket_(kj::mv(socket)) {}
  kj::Maybe<int> getFd() override { return socket_.get(); }

 private:
  const kj::AutoCloseFd socket_;
};

/// It is the first on the connection, which has room for so little.
bool say(rpc::ByteStream& bytes, const rpc::Token& token) {
  const auto opening = rpc::openingOf(token);
  return bytes.send(opening, {}) == static_cast<ssize_t>(opening.size());
}

kj::Exception refused(const std::string& text) {
  return rpc::failure(kj::Exception::Type::FAILED, text);
}

/// What no peer can guess.
template <class Value>
Value random() {
  Value value;
  if (getrandom(&value, sizeof(value), 0) == static_cast<ssize_t>(sizeof(value))) return value;
  throw SetupError("get random bytes for a connection", std::strerror(errno), "Try again");
}

bool isSame(const rpc::PeerIdentity& one, const rpc::PeerIdentity& other) {
  return one.proof == other.proof && one.user == other.user && one.process == other.process;
}

}  // namespace

std::uint32_t randomEpoch() { return random<std::uint32_t>(); }

wire::FrameSocket::Client FrameSockets::handOver(const AwaitingSocket& end) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, ends) != 0) {
    throw SetupError("make sockets for a connection", std::strerror(errno),
                     "Raise the limit of descriptors (ulimit -n)");
  }
  kj::AutoCloseFd ours(ends[0]), theirs(ends[1]);
  carry(end, kj::mv(ours));
  return kj::heap<SocketServer>(kj::mv(theirs));
}

rpc::Token FrameSockets::await(const AwaitingSocket& end, const rpc::PeerIdentity& who) {
  std::erase_if(awaited_, [](const auto& one) {
    return one.second.end.channel->status == ChannelStatus::Closed;
  });
  const auto token = random<rpc::Token>();
  awaited_.insert({token, {end, who}});
  return token;
}

void FrameSockets::arrived(const rpc::Token& token, rpc::ByteStream bytes) {
  const auto found = awaited_.find(token);
  if (found == awaited_.end() || !isSame(found->second.who, bytes.peer())) return;
  const AwaitingSocket end = found->second.end;
  awaited_.erase(found);
  if (say(bytes, token)) carry(end, kj::mv(bytes));
}

void FrameSockets::carry(const AwaitingSocket& end, rpc::ByteStream bytes) {
  auto side = std::make_shared<frame::ProviderSide>(end.channel, kj::mv(bytes), end.terms);
  if (end.readOnly) side->setReadOnly();
  lane_.add(std::move(side));
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

kj::Promise<rpc::ByteStream> showToken(kj::UnixEventPort& port, rpc::ByteStream bytes,
                                       capnp::Data::Reader token) {
  rpc::Token own;
  if (token.size() != own.size()) return refused("the provider's token has an impossible size");
  std::memcpy(own.data(), token.begin(), own.size());
  if (!say(bytes, own)) return refused("the second connection takes nothing");
  return rpc::readOpening(port, kj::mv(bytes), {})
      .then([own](rpc::Opened opened) -> kj::Promise<rpc::ByteStream> {
        KJ_IF_MAYBE (theirs, opened.token) {
          if (*theirs == own) return kj::mv(opened.bytes);
        }
        return refused("nobody awaits a second connection there");
      });
}

}  // namespace suture
