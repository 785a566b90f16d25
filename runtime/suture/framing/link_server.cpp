#include <suture/framing/link_server.h>
#include <suture/loop/failure.h>

#include <cerrno>
#include <cstring>

namespace suture::framing {
namespace {

// Limits the peers that are told at the same time that there are too many links.
constexpr std::size_t kMostTurnedAway = 16;

// Limits what messages take that have begun and not ended.
constexpr PeerBudget::Limits kUnfinished{.peer = 64u << 20, .process = 256u << 20};

net::Trust usable(const net::Trust& trust, const net::Address& address) {
  net::requireKeys(address, trust);
  return trust;
}

net::Listener::Opens opensOf(const net::Trust& trust, const net::Address& address) {
  const bool toOthers = address.kind == net::Address::Kind::Unix && !trust.users.empty();
  return toOthers ? net::Listener::Opens::ToOthers : net::Listener::Opens::ToOwner;
}

}  // namespace

using capnp::rpc::twoparty::Side;

capnp::Capability::Client turnAway(net::Refusals& refusals, const net::PeerIdentity& who,
                                   const std::string& text) {
  refusals.add(who.text(), text);
  return capnp::Capability::Client(loop::failure(kj::Exception::Type::FAILED, text));
}

LinkServer::LinkServer(loop::EventPort& port, const net::Address& address, Offer offer,
                       net::Refusals& refusals, StreamLimits limits, LinkLimits links,
                       const net::Trust& trust, Awaited awaited)
    : port_(port),
      trust_(usable(trust, address)),
      listener_(port, address, opensOf(trust, address)),
      offer_(kj::mv(offer)),
      refusals_(refusals),
      awaited_(kj::mv(awaited)),
      limits_(limits),
      most_(links),
      budget_(std::make_shared<PeerBudget>(kUnfinished)),
      tasks_(*this) {
  tasks_.add(listener_.listen([this](kj::AutoCloseFd socket) { accept(kj::mv(socket)); },
                              [this](int error) { cannotAccept(error); }));
}

void LinkServer::accept(kj::AutoCloseFd socket) {
  if (links_ == most_.all + kMostTurnedAway) {
    return refusals_.add(net::identityOf(socket).text(),
                         "talk to " + address().text() + ": " + tooMany());
  }
  const Room room = links_++ < most_.all ? Room::Is : Room::IsNot;
  // A failure here, perhaps for lack of memory, ends only this connection.
  auto served = kj::evalNow([&] {
    return address().kind == net::Address::Kind::Tls ? secure(kj::mv(socket), room)
                                                     : open(net::ByteStream(kj::mv(socket)), room);
  });
  tasks_.add(served.attach(kj::defer([this] { --links_; })));
}

// Peers that connect then wait in the kernel's queue.
void LinkServer::cannotAccept(int error) {
  const bool full = error == EMFILE || error == ENFILE || error == ENOBUFS || error == ENOMEM;
  refusals_.add("who connects to " + address().text(),
                std::string("wait until this process can accept connections again: ") +
                    std::strerror(error) +
                    (full ? ". Raise its limit (ulimit -n), or give it fewer peers."
                          : ". Look what keeps this machine from it: its network, a firewall."));
}

std::string LinkServer::tooMany() const {
  return "it has " + std::to_string(most_.all) +
         " links, and no process has more. End some of its peers.";
}

std::string LinkServer::tooManyOf(const std::string& peer) const {
  return std::to_string(most_.ofOne) + " of its links are with " + peer +
         ", and no peer has more. End some of them.";
}

kj::Promise<void> LinkServer::secure(kj::AutoCloseFd socket, Room room) {
  const auto deadline = std::chrono::milliseconds(limits_.handshakeMilliseconds);
  return net::handshake(port_, kj::mv(socket), trust_.keys, tls::Session::Side::Server, deadline)
      .then([this, room](net::ByteStream bytes) { return open(kj::mv(bytes), room); });
}

// One peer that leaks its links must leave room to the others. Those that only hear so count too.
kj::Promise<void> LinkServer::open(net::ByteStream bytes, Room room) {
  const net::PeerIdentity who = bytes.peer();
  if (who.proof == net::PeerIdentity::Proof::None) return begin(kj::mv(bytes), room);
  const auto own = ofPeers_.try_emplace(who.text()).first;
  if (own->second == most_.ofOne + kMostTurnedAway) {
    refusals_.add(own->first, "talk to " + address().text() + ": " + tooManyOf(own->first));
    return kj::READY_NOW;
  }
  if (own->second++ >= most_.ofOne && room == Room::Is) room = Room::IsNotForIt;
  auto leaves = kj::defer([this, own] {
    if (--own->second == 0) ofPeers_.erase(own);
  });
  return begin(kj::mv(bytes), room).attach(kj::mv(leaves));
}

kj::Promise<void> LinkServer::begin(net::ByteStream bytes, Room room) {
  return readPreamble(port_, kj::mv(bytes), limits_)
      .then([this, room](Opened opened) -> kj::Promise<void> {
        KJ_IF_MAYBE (token, opened.token) {
          awaited_(*token, kj::mv(opened.bytes));
          return kj::READY_NOW;
        }
        return serve(kj::mv(opened.bytes), opened.begun, room);
      });
}

kj::Promise<void> LinkServer::serve(net::ByteStream bytes, std::span<const std::byte> begun,
                                    Room room) {
  auto caller = std::make_shared<Caller>();
  caller->identity = bytes.peer();
  caller->budget = budget_;
  StrangerGuard guard{.known = {caller, &caller->known}, .share = caller->share()};
  auto stream = kj::heap<MessageStream>(port_, kj::mv(bytes), limits_, begun, std::move(guard));
  caller->counters = stream->counters();
  auto link = kj::heap<Link>(kj::mv(stream), Side::SERVER, offerTo(caller, room));
  const Link& ended = *link;
  return link->onDisconnect()
      .exclusiveJoin(whenStranger(caller))
      .then([this, &ended, caller] {
        if (ended.refusal().empty()) return;
        refusals_.add(caller->identity.text(),
                      "talk to " + address().text() + ": " + ended.refusal());
      })
      .attach(kj::mv(link));
}

capnp::Capability::Client LinkServer::offerTo(const std::shared_ptr<Caller>& caller, Room room) {
  const net::PeerIdentity& who = caller->identity;
  const std::string asked = "talk to " + address().text() + ": ";
  if (room == Room::IsNot) return turnAway(refusals_, who, asked + tooMany());
  if (room == Room::IsNotForIt) return turnAway(refusals_, who, asked + tooManyOf(who.text()));
  if (who.proof != net::PeerIdentity::Proof::User || net::isTrusted(who.user, trust_.users)) {
    return offer_(caller);
  }
  return turnAway(refusals_, who,
                  asked + "it does not talk to " + who.text() + ". Name that user in its policy.");
}

kj::Promise<void> LinkServer::whenStranger(std::shared_ptr<Caller> caller) {
  return port_.getTimer()
      .afterDelay(limits_.helloMilliseconds * kj::MILLISECONDS)
      .then([this, caller = std::move(caller)]() -> kj::Promise<void> {
        if (caller->known) return kj::NEVER_DONE;
        refusals_.add(caller->identity.text(),
                      "talk to " + address().text() +
                          ": see what that process does: it sends messages, and has not said who "
                          "it is for seconds");
        return kj::READY_NOW;
      });
}

void LinkServer::taskFailed(kj::Exception&& exception) {
  refusals_.add("a peer at " + address().text(), loop::describe(exception));
}

}  // namespace suture::framing
