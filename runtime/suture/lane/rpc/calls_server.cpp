#include <suture/lane/providers_ends.h>
#include <suture/lane/rpc/calls_server.h>
#include <suture/lane/rpc/servant.h>
#include <suture/loop/failure.h>

#include <span>
#include <string>
#include <utility>

namespace suture::rpc {
namespace {

using Type = kj::Exception::Type;

}  // namespace

/// A Bootstrap is what a client reaches through a socket.
class CallsServer::Bootstrap final : public wire::Calls::Server {
 public:
  Bootstrap(ServerSession& session, std::shared_ptr<Contracts> contracts)
      : session_(session), contracts_(std::move(contracts)) {}

 protected:
  kj::Promise<void> contract(ContractContext context) override {
    const auto found = contracts_->find(context.getParams().getConnection());
    if (found == contracts_->end()) {
      const char* const why = "no such connection has been accepted on this socket";
      session_.cutOff(why);
      return loop::failure(Type::FAILED, why);
    }
    kj::Own<ServantPort> port = kj::mv(found->second.port);
    contracts_->erase(found);
    if (context.getParams().hasCounts()) port->tellCounts(context.getParams().getCounts());
    context.getResults().setContract(kj::heap<Servant>(kj::mv(port)));
    return kj::READY_NOW;
  }

 private:
  ServerSession& session_;
  const std::shared_ptr<Contracts> contracts_;
};

std::shared_ptr<Channel> callsChannel(loop::ControlThread& control,
                                      const IncomingConnection& connection) {
  return std::make_shared<Channel>(connection.provided.info(), connection.terms, "rpc",
                                   providersEnds(connection, control.sharedDoorbell()),
                                   connection.provided.state(), connection.events);
}

kj::Own<ServantPort> serveCalls(loop::ControlThread& control, const IncomingConnection& connection,
                                std::shared_ptr<Channel> channel,
                                std::shared_ptr<const framing::LinkCounters> counters) {
  auto port = kj::refcounted<ServantPort>(control, std::move(channel), std::move(counters));
  if (connection.readOnly) port->setReadOnly();
  return port;
}

kj::Promise<AcceptedEnd> CallsServer::accept(IncomingConnection connection,
                                             capnp::AnyPointer::Reader brings,
                                             capnp::AnyPointer::Builder answer) {
  const auto found = sockets_.find(brings.getAs<wire::CallsRequest>().getSocket());
  if (found == sockets_.end()) return loop::failure(Type::FAILED, "the session's calls have ended");
  // A client that gave up waiting for the answer never asks for the contract.
  std::erase_if(*found->second.contracts, [](const auto& one) {
    return one.second.channel->status == ChannelStatus::Closed || !one.second.port->isShared();
  });
  auto channel = callsChannel(session_.control(), connection);
  auto port = serveCalls(session_.control(), connection, channel, found->second.link->counters());
  const std::uint32_t number = ++latest_;
  found->second.contracts->emplace(number, Offered{channel, kj::addRef(*port)});
  answer.initAs<wire::CallsAnswer>().setConnection(number);
  return AcceptedEnd{kj::mv(port), std::move(channel)};
}

void CallsServer::opened(LaneSocket socket) {
  const std::uint32_t number = socket.number;
  auto contracts = std::make_shared<Contracts>();
  framing::StrangerGuard guard{.known = nullptr, .share = std::move(socket.share)};
  auto stream = kj::heap<framing::MessageStream>(session_.control().port(), kj::mv(socket.bytes),
                                                 framing::StreamLimits{},
                                                 std::span<const std::byte>(), std::move(guard));
  auto link =
      kj::heap<framing::Link>(kj::mv(stream), capnp::rpc::twoparty::Side::SERVER,
                              wire::Calls::Client(kj::heap<Bootstrap>(session_, contracts)));
  sockets_.emplace(number, Socket{std::move(contracts), link.get()});
  auto ended = link->onDisconnect().then([this, number, &one = *link] {
    if (!one.refusal().empty()) session_.cutOff(one.refusal());
    sockets_.erase(number);
  });
  tasks_.add(ended.attach(kj::mv(link)));
}

}  // namespace suture::rpc
