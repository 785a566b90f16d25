#pragma once
// This is the provider's side of an rpc connection: the client's end of a channel, fed by remote
// calls.

#include <suture/loop/kj_comparisons.h>  // first

#include <kj/async.h>
#include <suture/calls.capnp.h>
#include <suture/framing/message_stream.h>
#include <suture/framing/remote_error.h>
#include <suture/lane/carrier/provider_carrier.h>
#include <suture/lane/carrier/row_slots.h>
#include <suture/lane/provider_end.h>
#include <suture/lane/rpc/subscriber.h>
#include <suture/lane/rpc/turn_ring.h>
#include <suture/loop/control_thread.h>
#include <suture/rpc.capnp.h>

#include <deque>
#include <memory>
#include <vector>

namespace suture::rpc {

/// An AnyCall is a call of any method, as Cap'n Proto gives it to a capability.
using AnyCall = capnp::CallContext<capnp::AnyPointer, capnp::AnyPointer>;

/// Belongs to the control thread; shared by the Servant and the connection. A call returns when its
/// credit goes back, if it uses one, or when its answer is there. Events and rows are calls too,
/// with at most kWindow of each unacknowledged, so that a slow client delays no other.
class ServantPort final : public ProviderEnd,
                          private ProviderCarrier::Wire,
                          private loop::Pump,
                          private kj::TaskSet::ErrorHandler {
 public:
  static constexpr unsigned kWindow = 4;

  /// `channel` has been, or will be, attached to the provider; its client doorbell is the control
  /// thread's.
  ServantPort(loop::ControlThread& control, std::shared_ptr<Channel> channel,
              std::shared_ptr<const framing::LinkCounters> counters);
  ~ServantPort() noexcept(false);

  /// Accepts only reads from now on: a command is refused (Errc::NotPermitted).
  void setReadOnly() { carrier_.setReadOnly(); }
  /// Sends `counts` the outcomes of the commands from now on, unless the connection is over.
  void tellCounts(wire::CommandCounts::Client counts);
  const InterfaceInfo& info() const { return channel_->info; }
  /// Handles a call of command `command`. A void or write command whose sender asked for no answer
  /// returns when its credit goes back, or at once if it uses none; all others return when the
  /// provider has answered.
  kj::Promise<void> command(std::uint16_t command, AnyCall call);

  /// Replaces the subscription, unless the connection is over. Events that the old one did not have
  /// count as joining, whatever `interest` says.
  void subscribe(Subscriber subscriber, Interest interest);

 private:
  struct PendingCall {
    std::uint32_t number = 0;  // 0: free
    std::uint16_t command = 0;
    kj::Own<kj::PromiseFulfiller<void>> done;
    kj::Maybe<AnyCall> call;
  };
  using Taken = kj::Own<kj::PromiseFulfiller<void>>;
  using Message = ProviderCarrier::Message;
  using Refusal = ProviderCarrier::Refusal;

  kj::Promise<void> await(std::uint16_t command, AnyCall call);
  Refusal post(std::uint16_t command, capnp::AnyPointer::Reader in, std::uint32_t call);
  kj::Promise<void> turnedAway(const Refusal& refusal);
  kj::Promise<void> whenTaken(std::uint16_t command);
  PendingCall* openCall(std::uint16_t command);

  void ending() override;
  void pump() override;
  bool isHeard() const { return subscriber_ != nullptr && !answering_; }
  bool hasRoom(Message message) const override;
  void send(const ReplyRecord& reply) override;
  void sendCredits(std::uint16_t command, std::uint32_t count) override;
  void send(const Tally& tally) override;
  void send(const rt::EventRecord& event, std::uint32_t subscription) override;
  bool sendRow(rt::ColumnSet columns, std::uint64_t& last) override;
  void answer(PendingCall& pending, const ReplyRecord& reply);
  kj::Exception failureOf(const PendingCall& call, Errc error) const;
  void eventTaken();
  void sendRow(Subscriber& subscriber, const rt::StateTable::Row& row);
  void tellTooLarge(rt::StateTable::Row row, const kj::Exception& failure);
  void rowTaken();
  bool isGone(const kj::Exception& failure, std::uint32_t subscription);
  void releaseRow();
  void changed(ChannelStatus status) override;
  void failAll(Errc error);
  void taskFailed(kj::Exception&& exception) override;

  loop::ControlThread& control_;
  const std::shared_ptr<const framing::LinkCounters> counters_;

  std::vector<std::deque<Taken>> taken_;  // by command: calls that use a credit, oldest first;
                                          // null if the call returns with its answer instead
  std::vector<PendingCall> calls_;        // as many as the channel has memory for answers
  std::uint32_t callsOpened_ = 0;

  kj::Maybe<Subscriber> subscriber_;
  std::uint32_t subscriptions_ = 0;  // how many so far
  bool answering_ = false;           // in subscribe(), which sends nothing before its answer
  kj::Maybe<wire::CommandCounts::Client> counts_;
  bool tallyInFlight_ = false;
  unsigned eventsInFlight_ = 0;
  unsigned rowsInFlight_ = 0;
  RowSlots row_;  // the row that is being sent
  ProviderCarrier carrier_;
  TurnRing provider_{control_, [this] { carrier_.ringProvider(); }};
  kj::TaskSet sending_;  // last: cancelled first
};

}  // namespace suture::rpc
