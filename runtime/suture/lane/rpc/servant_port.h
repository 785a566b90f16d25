#pragma once
// The provider's side of an rpc connection: the client endpoint of a channel, fed by remote calls.

#include <suture/loop/kj_comparisons.h>  // first

#include <kj/async.h>
#include <kj/function.h>
#include <suture/framing/message_stream.h>
#include <suture/framing/remote_error.h>
#include <suture/lane/provider_end.h>
#include <suture/lane/rpc/subscriber.h>
#include <suture/loop/control_thread.h>
#include <suture/rpc.capnp.h>

#include <array>
#include <deque>
#include <memory>
#include <vector>

namespace suture::rpc {

/// A call of any method, as Cap'n Proto hands it to a capability.
using AnyCall = capnp::CallContext<capnp::AnyPointer, capnp::AnyPointer>;

/// Puts the commands of one remote client into a provider's mailbox in the order of their arrival,
/// returns the answers, and sends events and rows with at most kWindow of each unacknowledged, so
/// that a slow client holds up nobody. Belongs to the control thread; shared by the
/// Servant and the connection.
class ServantPort final : public ProviderEnd, private Pump, private kj::TaskSet::ErrorHandler {
 public:
  static constexpr unsigned kWindow = 4;

  /// `channel` has been, or is about to be, attached to the provider; its client doorbell is the
  /// control thread's.
  ServantPort(ControlThread& control, std::shared_ptr<Channel> channel,
              std::shared_ptr<const LinkCounters> counters);
  ~ServantPort() noexcept(false);

  /// From now on only what reads is taken: a command is refused (Errc::NotPermitted).
  void setReadOnly() { readOnly_ = true; }
  const InterfaceInfo& info() const { return channel_->info; }
  /// A call of command `command`. A void or write command returns when the provider has taken it,
  /// or executed it if the sender asked for an answer; all others when the provider has answered.
  kj::Promise<void> command(std::uint16_t command, AnyCall call);

  /// Replaces the subscription.
  void subscribe(Subscriber subscriber, EventSet events, rt::ColumnSet columns);

 private:
  struct PendingCall {
    std::uint32_t number = 0;  // 0: free
    std::uint16_t command = 0;
    kj::Own<kj::PromiseFulfiller<void>> done;
    kj::Maybe<AnyCall> call;
  };
  using Taken = kj::Own<kj::PromiseFulfiller<void>>;
  struct Refusal {
    Errc error{};         // 0: there is none
    FieldPath invalid{};  // what is, of Errc::Invalid, as far as it was decoded
  };

  kj::Promise<void> await(std::uint16_t command, AnyCall call);
  Refusal post(std::uint16_t command, capnp::AnyPointer::Reader in, std::uint32_t call);
  kj::Promise<void> turnedAway(const Refusal& refusal);
  Time stampOf(wire::Sent::Reader sent) const;
  kj::Promise<void> whenTaken(std::uint16_t command);
  PendingCall* openCall(std::uint16_t command);

  void ending() override;
  void pump() override;
  void pumpCredits();
  void pumpTally();
  void pumpReplies();
  void answer(PendingCall& pending, const ReplyRecord& reply);
  kj::Exception failureOf(const PendingCall& call, Errc error) const;
  void pumpEvents();
  void pumpRow();
  bool wanted(const rt::EventRecord& record) const;
  void sendEvent(Subscriber& subscriber, const rt::EventRecord& record);
  void eventSent();
  void sendRow(Subscriber& subscriber, const rt::StateTable::Row& row);
  void releaseRow();
  void changed(ChannelStatus status) override;
  void failAll(Errc error);
  void taskFailed(kj::Exception&& exception) override;

  ControlThread& control_;
  const std::shared_ptr<const LinkCounters> counters_;
  bool readOnly_ = false;

  std::vector<std::deque<Taken>>
      taken_;                       // by command: calls that wait for their credit, oldest first
  std::vector<PendingCall> calls_;  // as many as the channel has memory for the answers of
  std::uint32_t callsOpened_ = 0;

  kj::Maybe<Subscriber> subscriber_;
  std::vector<Time> since_;  // by event: when it was subscribed to
  bool answering_ = false;   // subscribe(): nothing is sent before its answer
  rt::ColumnSet columns_ = 0;
  Tally tally_;  // as the client has been told
  bool tallyInFlight_ = false;
  unsigned eventsInFlight_ = 0;
  unsigned rowsInFlight_ = 0;
  std::uint64_t lastRow_ = 0;
  std::vector<std::vector<std::uint64_t>> rowSlots_;  // by column
  std::vector<std::byte*> rowPointers_;
  kj::TaskSet sending_;  // last: cancelled first
};

}  // namespace suture::rpc
