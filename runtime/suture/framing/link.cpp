#include <suture/framing/link.h>

namespace suture::framing {

Link::Link(kj::Own<MessageStream> stream, capnp::rpc::twoparty::Side side,
           kj::Maybe<capnp::Capability::Client> offers)
    : network_(kj::mv(stream), side), system_(network_, kj::mv(offers)) {}

capnp::Capability::Client Link::bootstrapCapability() {
  capnp::MallocMessageBuilder message(4);
  auto peer = message.getRoot<capnp::rpc::twoparty::VatId>();
  peer.setSide(network_.peerSide());
  return system_.bootstrap(peer);
}

}  // namespace suture::framing
