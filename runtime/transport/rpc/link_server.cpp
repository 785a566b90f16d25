#include <suture/transport/rpc/failure.h>
#include <suture/transport/rpc/link_server.h>

#include <cstdio>

namespace suture::rpc {
namespace {

// A peer that comes again and again fills no log.
constexpr auto kTellingPause = 1 * kj::SECONDS;

const Trust& usable(const Trust& trust, const Address& address) {
  requireKeys(address, trust);
  return trust;
}

Listener::Opens opensOf(const Trust& trust, const Address& address) {
  const bool toOthers = address.kind == Address::Kind::Unix && !trust.users.empty();
  return toOthers ? Listener::Opens::ToOthers : Listener::Opens::ToOwner;
}

}  // namespace

using capnp::rpc::twoparty::Side;

LinkServer::LinkServer(EventPort& port, const Address& address, Offer offer, StreamLimits limits,
                       std::size_t maxLinks, const Trust& trust, Awaited awaited)
    : port_(port),
      trust_(usable(trust, address)),
      listener_(port, address, opensOf(trust, address)),
      offer_(kj::mv(offer)),
      awaited_(kj::mv(awaited)),
      limits_(limits),
      maxLinks_(maxLinks),
      mayTell_(port.getTimer().now()),
      tasks_(*this) {
  tasks_.add(listener_.listen([this](kj::AutoCloseFd socket) { accept(kj::mv(socket)); }));
}

void LinkServer::accept(kj::AutoCloseFd socket) {
  if (links_ == maxLinks_) return;
  ++links_;
  // What fails here, for want of memory perhaps, is the end of this one alone.
  auto served = kj::evalNow([&] {
    return address().kind == Address::Kind::Tls ? secure(kj::mv(socket))
                                                : open(ByteStream(kj::mv(socket)));
  });
  tasks_.add(served.attach(kj::defer([this] { --links_; })));
}

kj::Promise<void> LinkServer::secure(kj::AutoCloseFd socket) {
  const auto deadline = std::chrono::milliseconds(limits_.handshakeMilliseconds);
  return handshake(port_, kj::mv(socket), trust_.keys, tls::Session::Side::Server, deadline)
      .then([this](ByteStream bytes) { return open(kj::mv(bytes)); });
}

kj::Promise<void> LinkServer::open(ByteStream bytes) {
  return readOpening(port_, kj::mv(bytes), limits_)
      .then([this](Opened opened) -> kj::Promise<void> {
        KJ_IF_MAYBE (token, opened.token) {
          awaited_(*token, kj::mv(opened.bytes));
          return kj::READY_NOW;
        }
        return serve(kj::mv(opened.bytes), opened.begun);
      });
}

kj::Promise<void> LinkServer::serve(ByteStream bytes, std::span<const std::byte> begun) {
  auto caller = std::make_shared<Caller>();
  caller->identity = bytes.peer();
  auto stream = kj::heap<MessageStream>(port_, kj::mv(bytes), limits_, begun);
  caller->counters = stream->counters();
  auto link = kj::heap<Link>(kj::mv(stream), Side::SERVER, offerTo(caller));
  auto gone = link->onDisconnect().exclusiveJoin(whenStranger(std::move(caller)));
  return gone.attach(kj::mv(link));
}

capnp::Capability::Client LinkServer::offerTo(const std::shared_ptr<Caller>& caller) {
  const PeerIdentity& who = caller->identity;
  if (who.proof != PeerIdentity::Proof::User || isTrusted(who.user, trust_.users)) {
    return offer_(caller);
  }
  return capnp::Capability::Client(failure(
      kj::Exception::Type::FAILED, "talk to " + address().text() + ": it does not talk to " +
                                       who.text() + ". Name that user in its policy."));
}

kj::Promise<void> LinkServer::whenStranger(std::shared_ptr<Caller> caller) {
  return port_.getTimer()
      .afterDelay(limits_.helloMilliseconds * kj::MILLISECONDS)
      .then([caller = std::move(caller)]() -> kj::Promise<void> {
        if (caller->known) return kj::NEVER_DONE;
        return kj::READY_NOW;
      });
}

void LinkServer::taskFailed(kj::Exception&& exception) {
  const kj::TimePoint now = port_.getTimer().now();
  if (now < mayTell_) return;
  mayTell_ = now + kTellingPause;
  std::fprintf(stderr, "suture: a peer at %s: %s\n", address().text().c_str(),
               describe(exception).c_str());
}

}  // namespace suture::rpc
