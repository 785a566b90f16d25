#pragma once
// A process is this to its peers: an address at which they connect to its provided interfaces.

#include <suture/framing/link_server.h>
#include <suture/lane/lanes.h>
#include <suture/loop/control_thread.h>
#include <suture/names/security.h>
#include <suture/net/refusals.h>
#include <suture/peer.capnp.h>
#include <suture/session/ledgers.h>
#include <suture/session/provider/awaited_sockets.h>
#include <suture/session/provider/latest_connections.h>
#include <suture/session/provider/limits/channel_memory.h>
#include <suture/session/provider/limits/places.h>
#include <suture/session/service_threads.h>
#include <suture/wiring/directory.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace suture {

/// Listens and serves. Belongs to the control thread except where noted.
class PeerHost {
 public:
  /// Throws SetupError as LinkServer does.
  PeerHost(loop::ControlThread& control, const Lanes& lanes, const Directory& directory,
           ServiceThreads& threads, std::uint64_t incarnation, const net::Address& address,
           const Security& security);

  const net::Address& address() const { return server_->address(); }

  /// Says that all components are in the directory: what is not there now does not exist.
  void publish() { published_->fulfill(); }

  /// Listens no more, and ends all links; address() is gone. Cap'n Proto cancels the calls that
  /// wait here in the next turns of the loop, so this must live until then.
  void hangUp() { server_.reset(); }

  /// Any thread. Returns how many peers and requests this process has refused.
  net::Refusals::Summary refusals() const { return refusals_.summary(); }

  /// Any thread. Returns the provider ends of the connections that exist.
  std::vector<std::shared_ptr<Channel>> served() const;

 private:
  friend class PeerServer;

  /// Returns what serves a new link: this process, or the reason why not.
  capnp::Capability::Client offerTo(std::shared_ptr<framing::Caller> caller);

  /// Takes a second connection that has come; refuses one that is not awaited.
  void arrived(const framing::Token& token, net::ByteStream bytes);

  using Latest = LatestConnections::Latest;

  /// Adds to served(), and drops channels that have been closed.
  void remember(std::shared_ptr<Channel> channel);
  /// Drops the closed channels of a client that stays. The last ones of a client that leaves are
  /// kept for the reports until another client connects.
  void forgetClosed();
  /// Lets go of the channels of devices that have ended: a device has no cycle in which it would.
  void sweep();

  loop::ControlThread& control_;
  const Lanes& lanes_;
  const Directory& directory_;
  ServiceThreads& threads_;
  const std::uint64_t incarnation_;  // of this process
  const Policy policy_;
  kj::Own<kj::PromiseFulfiller<void>> published_;
  kj::ForkedPromise<void> whenPublished_;
  Ledgers ledgers_{ConnectionEnd::Provider};
  LatestConnections latest_;
  ChannelMemory memory_;
  mutable std::mutex mutex_;
  std::vector<std::shared_ptr<Channel>> served_;
  AwaitedSockets sockets_;
  Places secondSockets_;  // all sessions share them, those that are awaited included
  net::Refusals refusals_;
  std::optional<framing::LinkServer> server_;  // last: its links use the rest
};

}  // namespace suture
