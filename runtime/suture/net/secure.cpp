#include <suture/base/errors.h>
#include <suture/base/virtual_time.h>
#include <suture/loop/deadline.h>
#include <suture/loop/failure.h>
#include <suture/net/dialer.h>
#include <suture/net/secure.h>
#include <sys/socket.h>
#include <unistd.h>

namespace suture::net {
namespace {

using Type = kj::Exception::Type;

/// This is a handshake under way.
class Handshake {
 public:
  Handshake(loop::EventPort& port, kj::AutoCloseFd socket, std::shared_ptr<const tls::Keys> keys,
            tls::Session::Side side)
      : socket_(kj::mv(socket)),
        side_(side),
        observer_(kj::heap<loop::EventPort::FdObserver>(
            port, socket_, loop::EventPort::FdObserver::OBSERVE_READ_WRITE)),
        session_(std::make_unique<tls::Session>(std::move(keys), side, socket_)) {}

  kj::Promise<ByteStream> go() {
    switch (advance()) {
      case tls::Session::Progress::WantsRead:
        return observer_->whenBecomesReadable().then([this] { return go(); });
      case tls::Session::Progress::WantsWrite:
        return observer_->whenBecomesWritable().then([this] { return go(); });
      case tls::Session::Progress::Done: break;
    }
    observer_ = nullptr;  // the next reader makes its own
    return ByteStream(kj::mv(socket_), std::move(session_));
  }

 private:
  tls::Session::Progress advance() {
    try {
      return session_->handshake();
    } catch (const tls::HandshakeError& error) {
      const bool broken = error.cause == tls::HandshakeError::Cause::Broken;
      const bool toServer = side_ == tls::Session::Side::Client;
      kj::throwFatalException(loop::failure(
          broken ? Type::DISCONNECTED : Type::FAILED,
          std::string(error.what()) + (broken && toServer ? std::string(" ") + kMayBeFull : "")));
    }
  }

  kj::AutoCloseFd socket_;
  const tls::Session::Side side_;
  kj::Own<loop::EventPort::FdObserver> observer_;
  std::unique_ptr<tls::Session> session_;
};

kj::Exception cannotTalk(const Address& address, const std::string& found,
                         Type type = Type::FAILED) {
  return loop::failure(type, "talk to " + address.text() + ": " + found);
}

kj::Promise<ByteStream> checkUser(ByteStream stream, const Address& address, const Trust& trust) {
  stream.setDialled(address.text());
  const PeerIdentity peer = stream.peer();
  if (peer.proof != PeerIdentity::Proof::User || isTrusted(peer.user, trust.users)) {
    return kj::mv(stream);
  }
  return cannotTalk(address, "it is run by " + peer.text() +
                                 ", whom this process does not trust. Use an address of your own, "
                                 "or name that user in the policy.");
}

// Returns false for TCP sockets, because the kernel does not say which process they belong to.
bool isOfAnotherProcess(int socket) {
  ucred peer{};
  socklen_t size = sizeof peer;
  const bool known = getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0;
  return known && peer.pid != 0 && peer.pid != getpid();
}

kj::Promise<ByteStream> checkClock(ByteStream stream, const Address& address) {
  if (virtualTime() == nullptr || !isOfAnotherProcess(stream.socket())) return kj::mv(stream);
  return cannotTalk(address,
                    "it is another process, which cannot follow the stepped clock of this one. Run "
                    "both in one process, or without a suture::TestClock.");
}

kj::Promise<ByteStream> checkProcess(ByteStream stream, const Address& address,
                                     const std::string& expected) {
  stream.setDialled(address.text());
  const PeerIdentity peer = stream.peer();
  if (peer.mayBe(expected)) return kj::mv(stream);
  return cannotTalk(address, "it has the certificate of " + peer.text() + ", and '" + expected +
                                 "' is expected there. Correct the address, or give it its own "
                                 "keys.");
}

}  // namespace

kj::Promise<ByteStream> handshake(loop::EventPort& port, kj::AutoCloseFd socket,
                                  std::shared_ptr<const tls::Keys> keys, tls::Session::Side side,
                                  Duration deadline) {
  auto under = kj::heap<Handshake>(port, kj::mv(socket), std::move(keys), side);
  auto done = kj::evalNow([&] { return under->go(); }).attach(kj::mv(under));
  return loop::unlessLate(port.getTimer(), deadline, kj::mv(done), []() -> kj::Promise<ByteStream> {
    return loop::disconnected("it did not finish the TLS handshake in time.");
  });
}

void requireKeys(const Address& address, const Trust& trust) {
  if (address.kind != Address::Kind::Tls || trust.keys != nullptr) return;
  throw SetupError("use the address " + address.text(), "this process has no keys",
                   "Make them with suture keys, and give their folder: key 'keys' of a deployment "
                   "file, or --keys.");
}

kj::Promise<ByteStream> reach(loop::EventPort& port, const Address& address, const Trust& trust,
                              const std::string& expected, Duration limit) {
  requireKeys(address, trust);
  auto dialled = dial(port, address, limit);
  if (address.kind != Address::Kind::Tls) {
    return dialled
        .then([address, trust](kj::AutoCloseFd socket) {
          return checkUser(ByteStream(kj::mv(socket)), address, trust);
        })
        .then([address](ByteStream stream) { return checkClock(kj::mv(stream), address); });
  }
  return dialled
      .then([&port, address, trust, limit](kj::AutoCloseFd socket) {
        return handshake(port, kj::mv(socket), trust.keys, tls::Session::Side::Client, 2 * limit)
            .catch_([address](kj::Exception&& error) -> kj::Promise<ByteStream> {
              return cannotTalk(address, loop::describe(error), error.getType());
            });
      })
      .then([address, expected](ByteStream stream) {
        return checkProcess(kj::mv(stream), address, expected);
      });
}

kj::Promise<ByteStream> reachFirst(loop::EventPort& port, std::vector<Address> places,
                                   const Trust& trust, const std::string& expected,
                                   Duration limit) {
  auto reached = reach(port, places.front(), trust, expected, limit);
  places.erase(places.begin());
  if (places.empty()) return reached;
  return reached.catch_([&port, places = std::move(places), trust, expected,
                         limit](kj::Exception&& failure) -> kj::Promise<ByteStream> {
    if (failure.getType() != kj::Exception::Type::DISCONNECTED) return kj::mv(failure);
    return reachFirst(port, places, trust, expected, limit);
  });
}

}  // namespace suture::net
