#include <suture/lane/rpc/calls_link.h>
#include <suture/net/socket.h>

#include <utility>

namespace suture::rpc {

CallsLink::CallsLink(loop::ControlThread& control, LaneSocket socket)
    : number_(socket.number),
      socket_(socket.bytes.socket()),
      link_(kj::heap<framing::MessageStream>(control.port(), kj::mv(socket.bytes)),
            capnp::rpc::twoparty::Side::CLIENT),
      peer_(link_.bootstrap<wire::Calls>()),
      ending_(link_.onDisconnect()
                  .then([this, &control] {
                    broken_ = true;
                    control.doorbell().ring();
                  })
                  .eagerlyEvaluate(nullptr)) {}

capnp::Capability::Client CallsLink::contract(std::uint32_t connection,
                                              wire::CommandCounts::Client counts) {
  auto request = peer_.contractRequest();
  request.setConnection(connection);
  request.setCounts(kj::mv(counts));
  return request.send().getContract();
}

void CallsLink::bear(Duration silence) const { net::breakWhenUnanswered(socket_, silence); }

}  // namespace suture::rpc
