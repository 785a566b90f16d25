#pragma once
// This is the client's side of an rpc connection: the provider's end of a channel, emptied into
// remote calls.

#include <suture/loop/kj_comparisons.h>  // first

#include <capnp/capability.h>
#include <kj/async.h>
#include <suture/component/channel/channel.h>
#include <suture/lane/carrier/client_carrier.h>
#include <suture/lane/client_end.h>
#include <suture/lane/rpc/calls_link.h>
#include <suture/lane/rpc/turn_ring.h>
#include <suture/loop/control_thread.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace suture::rpc {

/// Belongs to the control thread; shared by the connection and by the capabilities that receive
/// events. Sends each command of a client as a call, whose return gives its credit back.
class ProxyPort final : public ClientEnd,
                        private ClientCarrier::Wire,
                        private loop::Pump,
                        private kj::TaskSet::ErrorHandler {
 public:
  /// Once this many newest-wins commands are under way, the next wait in their cells, where newer
  /// ones replace them.
  static constexpr unsigned kWindow = 16;

  /// `channel`'s provider doorbell is the control thread's; its state table is a mirror that this
  /// writes.
  ProxyPort(loop::ControlThread& control, std::shared_ptr<Channel> channel,
            std::shared_ptr<const framing::LinkCounters> counters);
  ~ProxyPort() noexcept(false);

  /// Subscribes and sends what waits. `provider` must be of the contract's interface. `link` is
  /// what the calls travel on, and is held until the connection is over.
  void open(capnp::Capability::Client provider, std::shared_ptr<const CallsLink> link = nullptr);
  const InterfaceInfo& info() const { return channel_->info; }

  /// Takes over what the provider's end has counted.
  void tally(const Tally& tally);
  /// Takes a row.
  void publish(capnp::AnyPointer::Reader in);
  /// Takes event `event` of `subscription`. The promise is the answer to the provider; see
  /// acknowledge().
  kj::Promise<void> event(std::uint16_t event, std::uint32_t subscription,
                          capnp::AnyPointer::Reader in);

 private:
  Duration shift() const { return channel_->clockShift(); }
  /// Answers the newest event with the next command, or when another event arrives. A message for
  /// the answer alone would cost both processes a wake-up, and the provider goes on without it
  /// until ServantPort::kWindow events are unanswered.
  kj::Promise<void> acknowledge();
  void releaseAcknowledgement();
  void ending() override;
  void pump() override;
  void countBytes();
  bool hasRoom(ClientCarrier::Message message) const override;
  void send(const Interest& interest) override;
  void send(const rt::CommandRecord& command) override;
  void answer(std::uint16_t command, std::uint32_t call, capnp::AnyPointer::Reader results);
  void rejected(std::uint16_t command, std::uint32_t call, const kj::Exception& exception);
  void returned(std::uint16_t command, std::uint32_t call, Errc error);
  void taskFailed(kj::Exception&& exception) override;

  loop::ControlThread& control_;
  const std::shared_ptr<const framing::LinkCounters> counters_;
  std::shared_ptr<const CallsLink> link_;  // null: the provider is here, or the connection is over
  kj::Maybe<capnp::Capability::Client> provider_;
  unsigned latestInFlight_ = 0;
  std::vector<std::uint64_t> payload_;  // where an arriving event is decoded
  kj::Maybe<kj::Own<kj::PromiseFulfiller<void>>> acknowledgement_;
  ClientCarrier carrier_;
  TurnRing client_{control_, [this] { carrier_.ringClient(); }};
  kj::TaskSet calls_;  // last: cancelled first
};

}  // namespace suture::rpc
