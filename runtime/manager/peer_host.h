#pragma once
// What a process is to its peers: an address at which they connect to its provided interfaces.

#include <suture/manager/network.h>
#include <suture/peer.capnp.h>
#include <suture/transport/rpc/control_thread.h>
#include <suture/transport/rpc/link_server.h>
#include <suture/transport/rpc/servant_port.h>
#include <suture/wiring/directory.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace suture {

/// Listens and serves. Belongs to the control thread except where noted.
class PeerHost {
 public:
  /// Throws SetupError as LinkServer does.
  PeerHost(rpc::ControlThread& control, const Directory& directory, Network::ServerOf serverOf,
           const rpc::Address& address);

  const rpc::Address& address() const { return server_.address(); }

  /// All components are in the directory: what is not there now does not exist.
  void publish() { published_->fulfill(); }

  /// Any thread: the provider ends of the connections that stand.
  std::vector<std::shared_ptr<Channel>> served() const;

 private:
  friend class PeerServer;

  /// Adds to served(), and forgets those that have been closed.
  void remember(std::shared_ptr<Channel> channel);

  rpc::ControlThread& control_;
  const Directory& directory_;
  const Network::ServerOf serverOf_;
  kj::Own<kj::PromiseFulfiller<void>> published_;
  kj::ForkedPromise<void> whenPublished_;
  mutable std::mutex mutex_;
  std::vector<std::shared_ptr<Channel>> served_;
  rpc::LinkServer server_;  // last: its links use the rest
};

/// Identifies a start of this machine: processes with the same share the steady clock.
std::string bootId();

}  // namespace suture
