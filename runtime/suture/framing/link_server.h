#pragma once
// This serves Cap'n Proto RPC at an address, with one link for each connection.

#include <suture/framing/link.h>
#include <suture/framing/peer_budget.h>
#include <suture/framing/preamble.h>
#include <suture/net/listener.h>
#include <suture/net/refusals.h>
#include <suture/net/secure.h>

#include <map>
#include <memory>
#include <string>

namespace suture::framing {

/// Belongs to the control thread. A Caller is the peer at the other end of an accepted link.
struct Caller {
  net::PeerIdentity identity;
  std::shared_ptr<const LinkCounters> counters;  ///< what the link has counted, for reports
  std::shared_ptr<PeerBudget> budget;            ///< the server's room for unfinished messages
  /// The code that serves the peer sets this, once the peer has said what it wants. A link on which
  /// this stays false is closed after StreamLimits::helloMilliseconds.
  bool known = false;

  /// Returns what one more stream of the peer counts its unfinished messages by.
  std::unique_ptr<PeerBudget::Share> share() const {
    return std::make_unique<PeerBudget::Share>(budget, identity.text());
  }
};

/// Adds `text` to `refusals`, and returns a capability for the peer on which every call fails with
/// it.
capnp::Capability::Client turnAway(net::Refusals& refusals, const net::PeerIdentity& who,
                                   const std::string& text);

/// Limits the links of a server.
struct LinkLimits {
  std::size_t all = 1024;
  std::size_t ofOne = all / 4;  ///< those with one certificate or one user
};

/// Belongs to the control thread. Accepts connections until it is destroyed, which closes all its
/// links.
class LinkServer final : private kj::TaskSet::ErrorHandler {
 public:
  /// Makes the bootstrap capability of each new link.
  using Offer = kj::Function<capnp::Capability::Client(std::shared_ptr<Caller>)>;

  /// The server calls this with each connection that is not a link, see preamble.h.
  using Awaited = kj::Function<void(const Token&, net::ByteStream)>;

  /// Throws SetupError as Listener does, or if the address needs keys and `trust` has none. At
  /// tls:// a peer without a certificate of the CA gets no link. At unix: a peer that is run by a
  /// user who is not trusted gets a link on which it only hears why it is refused, and so does each
  /// of a few peers beyond `links` at a time; any more are closed without an answer. All of them
  /// are added to `refusals`. At tcp:// nobody proves who it is, so only `links.all` holds there.
  LinkServer(
      loop::EventPort& port, const net::Address& address, Offer offer, net::Refusals& refusals,
      StreamLimits limits = {}, LinkLimits links = {}, const net::Trust& trust = {},
      Awaited awaited = [](const Token&, net::ByteStream) {});

  const net::Address& address() const { return listener_.address(); }

 private:
  void accept(kj::AutoCloseFd socket);
  void cannotAccept(int error);
  /// Says if there was room for a link when its peer came: for any, and for one more of that peer.
  enum class Room { Is, IsNot, IsNotForIt };

  kj::Promise<void> secure(kj::AutoCloseFd socket, Room room);
  kj::Promise<void> open(net::ByteStream bytes, Room room);
  kj::Promise<void> begin(net::ByteStream bytes, Room room);
  kj::Promise<void> serve(net::ByteStream bytes, std::span<const std::byte> begun, Room room);
  capnp::Capability::Client offerTo(const std::shared_ptr<Caller>& caller, Room room);
  std::string tooMany() const;
  std::string tooManyOf(const std::string& peer) const;
  kj::Promise<void> whenStranger(std::shared_ptr<Caller> caller);
  void taskFailed(kj::Exception&& exception) override;

  loop::EventPort& port_;
  const net::Trust trust_;
  net::Listener listener_;
  Offer offer_;
  net::Refusals& refusals_;
  Awaited awaited_;
  StreamLimits limits_;
  LinkLimits most_;
  std::size_t links_ = 0;
  std::map<std::string, std::size_t> ofPeers_;  // by what they have proved
  const std::shared_ptr<PeerBudget> budget_;
  kj::TaskSet tasks_;  // last: cancelled first
};

}  // namespace suture::framing
