#pragma once
// A process is this to its peers: an address at which they connect to its provided interfaces.

#include <suture/framing/link_server.h>
#include <suture/session/provider/shared/shared_by_sessions.h>

#include <memory>
#include <optional>
#include <vector>

namespace suture {

/// Listens and serves. Belongs to the control thread except where noted.
class PeerHost {
 public:
  /// Throws SetupError as LinkServer does.
  PeerHost(ServingProcess process, const net::Address& address, net::Trust trust);

  const net::Address& address() const { return server_->address(); }

  /// Says that all components are in the directory: what is not there now does not exist.
  void publish() { shared_.published.reach(); }

  /// Listens no more, and ends all links; address() is gone. Cap'n Proto cancels the calls that
  /// wait here in the next turns of the loop, so this must live until then.
  void hangUp() { server_.reset(); }

  /// Any thread. Returns how many peers and requests this process has refused.
  net::Refusals::Summary refusals() const { return shared_.refusals.summary(); }

  /// Any thread. Returns the provider ends of the connections that exist.
  std::vector<std::shared_ptr<Channel>> served() const { return shared_.channels.all(); }

 private:
  /// Returns what serves a new link: this process, or the reason why not.
  capnp::Capability::Client offerTo(std::shared_ptr<framing::Caller> caller);

  /// Takes a second connection that has come; refuses one that is not awaited.
  void arrived(const framing::Token& token, net::ByteStream bytes);

  SharedBySessions shared_;
  std::optional<framing::LinkServer> server_;  // last: its links use the rest
};

}  // namespace suture
