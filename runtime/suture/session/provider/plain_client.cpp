#include <suture/lane/rpc/calls_server.h>
#include <suture/lane/rpc/servant.h>
#include <suture/session/provider/plain_client.h>

#include <utility>

namespace suture {
namespace {

IncomingConnection plainConnection(ServedPeer& peer, ProvidedBase& provided,
                                   const Endpoint& endpoint) {
  return {.provided = provided,
          .contract = provided.info(),
          .terms = {.name = "(a plain client) -> " + endpoint.toString()},
          .events = ~EventSet{0},
          .provider = peer.shared().threads.serverOf(provided),
          .readOnly = peer.admission().mayOnlyRead(endpoint)};
}

}  // namespace

kj::Promise<void> openForPlainClient(ServedPeer& peer, HeldConnections& held, OpenContext context) {
  const auto asked = context.getParams();
  const Endpoint endpoint = peer.endpoint(asked.getComponent(), asked.getInterface());
  HeldConnections::Room room;
  auto withheld = peer.admission().whyNotNames({asked.getComponent(), asked.getInterface()});
  if (!withheld) withheld = held.whyNoPlace(endpoint, room);
  if (!withheld) withheld = peer.admission().whyNotInterface(endpoint);
  return peer.serve(
      context, withheld, [&peer, &held, context, endpoint, room]() mutable -> kj::Promise<void> {
        SharedBySessions& shared = peer.shared();
        ProvidedBase& provided = shared.directory.provided(endpoint);
        const IncomingConnection connection = plainConnection(peer, provided, endpoint);
        const std::size_t bytes = Channel::bytesFor(provided.info());
        if (const auto refusal = held.whyNoMemory(endpoint, room, bytes)) {
          peer.refuse(*refusal, context.getResults().initRefused());
          return kj::READY_NOW;
        }
        auto channel = rpc::callsChannel(shared.control, connection);
        auto port = rpc::serveCalls(shared.control, connection, channel, peer.caller().counters);
        held.keep(kj::addRef(*port), channel, room);
        shared.channels.attach(provided, std::move(channel));
        context.getResults().setContract(kj::heap<rpc::Servant>(kj::mv(port)));
        return kj::READY_NOW;
      });
}

}  // namespace suture
