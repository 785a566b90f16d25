#include <suture/transport/rpc/link.h>

#include <capnp/rpc.capnp.h>

namespace suture::rpc {
namespace {

using capnp::rpc::twoparty::Side;
using capnp::rpc::twoparty::VatId;

capnp::ReaderOptions readerOptions(const StreamLimits& limits) {
  capnp::ReaderOptions options;
  options.traversalLimitInWords = limits.messageBytes / sizeof(capnp::word);
  return options;
}

/// The caller's last word on a call that has returned: only frees memory at the peer.
bool isFinish(MessageStream::Segments message) {
  capnp::SegmentArrayMessageReader reader(message);
  return reader.getRoot<capnp::rpc::Message>().isFinish();
}

}  // namespace

Link::Link(kj::Own<MessageStream> stream, Side side, kj::Maybe<capnp::Capability::Client> offers,
           const StreamLimits& limits)
    : stream_(kj::mv(stream)),
      network_(*stream_, side, readerOptions(limits)),
      system_(network_, kj::mv(offers)) {
  stream_->letRide(isFinish);
}

capnp::Capability::Client Link::bootstrapCapability() {
  capnp::MallocMessageBuilder message(4);
  auto peer = message.getRoot<VatId>();
  peer.setSide(network_.getSide() == Side::CLIENT ? Side::SERVER : Side::CLIENT);
  return system_.bootstrap(peer);
}

}  // namespace suture::rpc
