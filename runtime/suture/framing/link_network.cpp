#include <suture/framing/link_network.h>

#include <capnp/rpc.capnp.h>
#include <kj/refcount.h>
#include <suture/framing/remote_error.h>
#include <suture/loop/failure.h>
#include <suture/net/secure.h>

namespace suture::framing {

using capnp::rpc::twoparty::Side;
using capnp::rpc::twoparty::VatId;
using Base = capnp::TwoPartyVatNetworkBase;

/// An Outgoing is a message that is being built. Most messages fit into the room inside this
/// object; the rest of a longer one goes into further segments.
class LinkNetwork::Outgoing final : public capnp::OutgoingRpcMessage {
 public:
  explicit Outgoing(LinkNetwork& network) : network_(network), message_(room_) {}

  capnp::AnyPointer::Builder getBody() override { return message_.getRoot<capnp::AnyPointer>(); }

  void send() override {
    // A peer that receives more than it allows ends the link, but only this call should fail. What
    // is thrown here becomes the outcome of the call.
    const auto segments = message_.getSegmentsForOutput();
    const std::size_t bytes = bytesOfMessage(segments);
    MessageStream& stream = *network_.stream_;
    if (bytes > stream.limits().messageBytes) {
      kj::throwFatalException(remoteError(Errc::TooLarge));
    }
    const auto message = message_.getRoot<capnp::rpc::Message>().asReader();
    network_.answers_.sent(message, bytes);
    // A Finish, which ends a call that has returned, only frees memory at the peer.
    using Leaves = MessageStream::Leaves;
    stream.write(segments, message.isFinish() ? Leaves::WithNextMessage : Leaves::AtEndOfTurn,
                 descriptors_);
  }

  void setFds(kj::Array<int> descriptors) override { descriptors_ = kj::mv(descriptors); }

  std::size_t sizeInWords() override {
    std::size_t words = 0;
    for (const auto segment : message_.getSegmentsForOutput()) words += segment.size();
    return words;
  }

 private:
  // Blocks of up to 1032 bytes are those that malloc keeps at hand for each thread.
  static constexpr std::size_t kRoom = 88;

  LinkNetwork& network_;
  capnp::word room_[kRoom] = {};
  capnp::MallocMessageBuilder message_;
  kj::Array<int> descriptors_;
};

class LinkNetwork::Only final : public Base::Connection, public kj::Refcounted {
 public:
  explicit Only(LinkNetwork& network) : network_(network) {
    network_.only_ = this;
    peer_.getRoot<VatId>().setSide(network.peerSide());
  }
  ~Only() noexcept(false) {
    network_.only_ = nullptr;
    network_.gone_->fulfill();
  }

  VatId::Reader getPeerVatId() override { return peer_.getRoot<VatId>(); }

  kj::Own<capnp::OutgoingRpcMessage> newOutgoingMessage(capnp::uint) override {
    return kj::heap<Outgoing>(network_);
  }

  kj::Promise<Incoming> receiveIncomingMessage() override { return network_.receive(); }

  kj::Promise<void> shutdown() override { return network_.stream_->end(); }

 private:
  LinkNetwork& network_;
  capnp::MallocMessageBuilder peer_{4};
};

LinkNetwork::LinkNetwork(kj::Own<MessageStream> stream, Side side)
    : stream_(kj::mv(stream)), side_(side) {
  auto pair = kj::newPromiseAndFulfiller<void>();
  gone_ = kj::mv(pair.fulfiller);
  disconnected_ = pair.promise.fork();
  stream_->setJudge([this](capnp::IncomingRpcMessage& message, bool isStranger) {
    const StreamLimits& limits = stream_->limits();
    return answers_.arrived(message.getBody().getAs<capnp::rpc::Message>(),
                            isStranger
                                ? UnfinishedAnswers::Limits{.questions = limits.strangerQuestions,
                                                            .bytes = limits.strangerBytes}
                                : UnfinishedAnswers::Limits{.questions = limits.questions,
                                                            .bytes = limits.answerBytes});
  });
}

kj::Promise<LinkNetwork::Incoming> LinkNetwork::receive() {
  const bool answers = side_ == Side::SERVER;
  return answers || begun_ ? stream_->read() : receiveFirst();
}

// A server that has as many links as it may have closes a further one without a word. What it has
// not read by then makes that a reset.
kj::Promise<LinkNetwork::Incoming> LinkNetwork::receiveFirst() {
  const auto unanswered = [this](const std::string& how) {
    const std::string& dialled = stream_->dialled();
    return loop::disconnected("the peer" + (dialled.empty() ? "" : " at " + dialled) + how +
                              " before a word. " + net::kMayBeFull);
  };
  return stream_->read().then(
      [this, unanswered](Incoming message) -> Incoming {
        if (message == nullptr) kj::throwFatalException(unanswered(" closed the connection"));
        begun_ = true;
        return message;
      },
      [this, unanswered](kj::Exception&& failure) -> Incoming {
        const bool unheard = stream_->counters()->receivedBytes == 0 && refusal().empty();
        if (!unheard) kj::throwFatalException(kj::mv(failure));
        kj::throwFatalException(unanswered(": " + loop::describe(failure)));
      });
}

Side LinkNetwork::peerSide() const { return side_ == Side::CLIENT ? Side::SERVER : Side::CLIENT; }

kj::Own<Base::Connection> LinkNetwork::connection() {
  if (only_ != nullptr) return kj::addRef(*only_);
  return kj::refcounted<Only>(*this);
}

kj::Maybe<kj::Own<Base::Connection>> LinkNetwork::connect(VatId::Reader peer) {
  if (peer.getSide() == side_) return nullptr;
  return connection();
}

kj::Promise<kj::Own<Base::Connection>> LinkNetwork::accept() {
  if (side_ == Side::CLIENT || accepted_) return kj::NEVER_DONE;
  accepted_ = true;
  return connection();
}

}  // namespace suture::framing
