#pragma once
// This is the lane of calls in the provider's process.

#include <suture/calls.capnp.h>
#include <suture/framing/link.h>
#include <suture/lane/lane_kind.h>
#include <suture/lane/rpc/servant_port.h>

#include <map>
#include <memory>

namespace suture::rpc {

/// Returns the provider's channel of a connection by calls.
std::shared_ptr<Channel> callsChannel(loop::ControlThread& control,
                                      const IncomingConnection& connection);

/// Serves it; the calls that are counted come by the link that has `counters`.
kj::Own<ServantPort> serveCalls(loop::ControlThread& control, const IncomingConnection& connection,
                                std::shared_ptr<Channel> channel,
                                std::shared_ptr<const framing::LinkCounters> counters);

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
  /// This is a connection of one socket, until its client asks for the contract.
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
  std::uint32_t latest_ = 0;                 // the latest connection
  kj::TaskSet tasks_;                        // last: cancelled first
};

}  // namespace suture::rpc
