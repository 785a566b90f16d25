#pragma once
// One required interface of this process, connected to a provided one over Cap'n Proto RPC.

#include <suture/component/required.h>
#include <suture/manager/manager_link.h>
#include <suture/manager/network.h>
#include <suture/peer.capnp.h>
#include <suture/transport/rpc/proxy_port.h>
#include <suture/wiring/endpoint.h>

#include <functional>
#include <memory>
#include <string>

namespace suture {

/// Owns a link of its own, so that no other connection can hold it up. When the link breaks the
/// required interface is Lost at once, and the connection is made anew, with back-off, for as long
/// as this lives. Belongs to the control thread; outlives its promises.
class RemoteConnection {
 public:
  /// Told each channel, when the connection has been made or made anew.
  using Made = std::function<void(std::shared_ptr<Channel>)>;

  /// `from` and `to` with their processes.
  RemoteConnection(rpc::ControlThread& control, ManagerLink& manager, RequiredBase& required,
                   Endpoint from, Endpoint to, Made made, const Interposer& interposer,
                   std::shared_ptr<ConnectionWatch> watch);
  ~RemoteConnection() noexcept(false);

  /// Connects, waiting at most `patience` for the other process and its component. Rejects with the
  /// reason.
  kj::Promise<void> open(Duration patience);
  /// Takes the connection down for good: that is no loss to the client.
  void end();

 private:
  class NoticesReceiver;

  kj::Promise<void> connect(Duration patience);
  kj::Promise<void> dial(const ProcessRecord& process);
  kj::Promise<void> greet();
  kj::Promise<void> ask();
  void begin(wire::ConnectResults::Accepted::Reader accepted);
  kj::Promise<void> keep();
  kj::Promise<void> comeBack(Duration pause);
  kj::Promise<void> whenSilent();
  void lost();

  rpc::ControlThread& control_;
  ManagerLink& manager_;
  RequiredBase& required_;
  const Endpoint from_, to_;
  const Made made_;
  const Interposer interposer_;
  const std::shared_ptr<ConnectionWatch> watch_;  // of all its channels
  std::shared_ptr<Channel> channel_;
  kj::Maybe<kj::Own<rpc::Link>> link_;
  kj::Maybe<wire::Peer::Client> peer_;
  kj::Maybe<wire::Connection::Client> connection_;
  kj::Maybe<kj::Own<rpc::ProxyPort>> port_;
  Duration clockOffset_{0};                    // the peer's clock minus ours
  kj::Promise<void> keeping_ = kj::READY_NOW;  // last: cancelled first
};

}  // namespace suture
