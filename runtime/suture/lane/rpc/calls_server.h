#pragma once
// This is the rpc lane in the provider's process.

#include <suture/calls.capnp.h>
#include <suture/framing/link.h>
#include <suture/lane/lane_kind.h>
#include <suture/lane/rpc/servant_port.h>

#include <map>
#include <memory>

namespace suture::rpc {

/// Returns a channel for a connection over the rpc lane. Its client doorbell is the control
/// thread's.
std::shared_ptr<Channel> callsChannel(loop::ControlThread& control,
                                      const IncomingConnection& connection);

/// Returns the port that serves a channel of callsChannel(). `counters` are those of the link by
/// which its calls come.
kj::Own<ServantPort> serveCalls(loop::ControlThread& control, const IncomingConnection& connection,
                                std::shared_ptr<Channel> channel,
                                std::shared_ptr<const framing::LinkCounters> counters);

/// A CallsServer belongs to the control thread. Its client asks on one of its sockets for the
/// contract of a connection, and calls that.
class CallsServer final : public LaneServer, private kj::TaskSet::ErrorHandler {
 public:
  explicit CallsServer(ServerSession& session) : session_(session), tasks_(*this) {}

  kj::Promise<AcceptedEnd> accept(IncomingConnection connection, capnp::AnyPointer::Reader brings,
                                  capnp::AnyPointer::Builder answer) override;
  std::size_t bytesFor(const IncomingConnection& connection) const override {
    return Channel::bytesFor(connection.provided.info());
  }
  void opened(LaneSocket socket) override;

 private:
  /// Holds a connection that was accepted on a socket, until its client asks for the contract.
  struct Offered {
    std::shared_ptr<Channel> channel;
    kj::Own<ServantPort> port;
  };
  using Contracts = std::map<std::uint32_t, Offered>;
  class Bootstrap;
  struct Socket {
    std::shared_ptr<Contracts> contracts;
    framing::Link* link;
  };

  void taskFailed(kj::Exception&&) override {}

  ServerSession& session_;
  std::map<std::uint32_t, Socket> sockets_;  // by number
  std::uint32_t latest_ = 0;                 // the number of the latest connection
  kj::TaskSet tasks_;                        // last: cancelled first
};

}  // namespace suture::rpc
