#pragma once
// Cap'n Proto's RPC system talks through this: one message stream, without promises in between.

#include <suture/loop/kj_comparisons.h>  // first

#include <capnp/rpc-twoparty.h>
#include <suture/framing/message_stream.h>
#include <suture/framing/unfinished_answers.h>

#include <memory>

namespace suture::framing {

/// Belongs to the control thread; must outlive the RPC system on it. A LinkNetwork is a network of
/// two processes. Messages go straight into the stream's buffer and come straight out of it,
/// whereas the library's own network queues each behind a promise of the one before.
class LinkNetwork final : public capnp::TwoPartyVatNetworkBase {
 public:
  LinkNetwork(kj::Own<MessageStream> stream, capnp::rpc::twoparty::Side side);

  capnp::rpc::twoparty::Side peerSide() const;
  std::shared_ptr<const LinkCounters> counters() const { return stream_->counters(); }
  const std::string& refusal() const { return stream_->refusal(); }
  /// Resolves when the RPC system has let go of the connection; never rejects.
  kj::Promise<void> onDisconnect() { return disconnected_.addBranch(); }

  kj::Maybe<kj::Own<capnp::TwoPartyVatNetworkBase::Connection>> connect(
      capnp::rpc::twoparty::VatId::Reader peer) override;
  kj::Promise<kj::Own<capnp::TwoPartyVatNetworkBase::Connection>> accept() override;

 private:
  class Outgoing;
  class Only;  // the one connection there is

  using Incoming = kj::Maybe<kj::Own<capnp::IncomingRpcMessage>>;

  kj::Own<capnp::TwoPartyVatNetworkBase::Connection> connection();
  kj::Promise<Incoming> receive();
  kj::Promise<Incoming> receiveFirst();

  kj::Own<MessageStream> stream_;
  const capnp::rpc::twoparty::Side side_;
  UnfinishedAnswers answers_;
  bool accepted_ = false;
  bool begun_ = false;    // the peer has sent a message
  Only* only_ = nullptr;  // set while the RPC system holds it
  kj::Own<kj::PromiseFulfiller<void>> gone_;
  kj::ForkedPromise<void> disconnected_ = nullptr;
};

}  // namespace suture::framing
