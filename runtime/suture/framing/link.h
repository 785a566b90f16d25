#pragma once
// This is one connection between two processes that speaks Cap'n Proto RPC.

#include <suture/loop/kj_comparisons.h>  // first

#include <suture/framing/link_network.h>

#include <memory>

namespace suture::framing {

/// Belongs to the control thread. A Link is a stream with an RPC system on it. Destroying it closes
/// it, and breaks every capability that came through it (DISCONNECTED).
class Link {
 public:
  /// `offers` is what the peer gets when it asks for the bootstrap capability.
  Link(kj::Own<MessageStream> stream, capnp::rpc::twoparty::Side side,
       kj::Maybe<capnp::Capability::Client> offers = nullptr);

  /// Returns the peer's bootstrap capability.
  template <class Interface>
  typename Interface::Client bootstrap() {
    return bootstrapCapability().castAs<Interface>();
  }

  /// Resolves when the peer is gone; never rejects.
  kj::Promise<void> onDisconnect() { return network_.onDisconnect(); }

  /// Returns why it ended, if the peer broke a limit; else "".
  const std::string& refusal() const { return network_.refusal(); }

  std::shared_ptr<const LinkCounters> counters() const { return network_.counters(); }

 private:
  capnp::Capability::Client bootstrapCapability();

  LinkNetwork network_;
  capnp::RpcSystem<capnp::rpc::twoparty::VatId> system_;
};

}  // namespace suture::framing
