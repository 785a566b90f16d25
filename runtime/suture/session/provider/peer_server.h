#pragma once
// This is one peer's view of this process.

#include <suture/peer.capnp.h>
#include <suture/session/provider/connections/held_connections.h>
#include <suture/session/provider/lane_servers.h>
#include <suture/session/provider/second_sockets.h>
#include <suture/session/provider/served_peer.h>

#include <memory>
#include <string>
#include <vector>

namespace suture {

/// A PeerServer is the bootstrap capability of one link, and holds what this process keeps of the
/// session that the link carries. When the link goes, so do the connections made through it.
class PeerServer final : public wire::Peer::Server, private ServerSession {
 public:
  PeerServer(SharedBySessions& shared, std::shared_ptr<framing::Caller> caller);
  ~PeerServer() noexcept(false);

 protected:
  kj::Promise<void> hello(HelloContext context) override;
  kj::Promise<void> connect(ConnectContext context) override;
  kj::Promise<void> describe(DescribeContext context) override;
  kj::Promise<void> ping(PingContext context) override;
  kj::Promise<void> open(OpenContext context) override;
  kj::Promise<void> explain(ExplainContext context) override;
  kj::Promise<void> socket(SocketContext context) override;
  kj::Promise<void> compared(ComparedContext context) override;

 private:
  loop::ControlThread& control() override { return shared_.control; }
  void cutOff(const std::string& why) override;

  kj::Promise<void> awaitSocket(LaneServer& lane, SocketContext& context);
  void putTasks(wire::Peer::PingResults::Builder results) const;

  SharedBySessions& shared_;
  ServedPeer peer_;
  std::vector<std::string> watched_;  // components that it gets reports of
  HeldConnections held_;
  LaneServers lanes_;
  SecondSockets sockets_;  // last: those that come go to the lanes
};

}  // namespace suture
