#pragma once
// The provider's side of an rpc connection: the client endpoint of a channel, fed by remote calls.

#include <suture/loop/kj_comparisons.h>  // first

#include <kj/async.h>
#include <kj/function.h>
#include <suture/framing/message_stream.h>
#include <suture/framing/remote_error.h>
#include <suture/lane/provider_end.h>
#include <suture/lane/rpc/binding.h>
#include <suture/loop/control_thread.h>
#include <suture/rpc.capnp.h>

#include <array>
#include <deque>
#include <memory>
#include <vector>

namespace suture::rpc {

/// Puts the commands of one remote client into a provider's mailbox in the order of their arrival,
/// returns the answers, and sends events and rows with at most kWindow of each unacknowledged, so
/// that a slow client holds up nobody. Belongs to the control thread; shared by the generated
/// servant and the connection.
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
  /// Turns the peer's steady clock into this process's.
  Duration shift() const { return channel_->clockShift(); }

  // --- for generated servants

  /// A void or write command. `fill(std::byte* slot)` converts the arguments and returns an Errc.
  /// Returns when the provider has taken it, or executed it if the sender asked for an answer.
  template <class Fill>
  kj::Promise<void> command(std::uint16_t command, wire::Sent::Reader sent, const Fill& fill) {
    if (sent.getAnswer()) return call(command, sent, fill, [](const std::byte*, Time) {});
    const Refusal refusal = post(command, sent, 0, fill);
    if (refusal.error != Errc{}) return turnedAway(refusal);
    return whenTaken(command);
  }

  /// A read or qualified read, evaluated by the provider. `take(const std::byte* slot, Time
  /// stamp)` converts the result, produced at `stamp`.
  template <class Fill, class Convert>
  kj::Promise<void> call(std::uint16_t command, wire::Sent::Reader sent, const Fill& fill,
                         Convert take) {
    PendingCall* pending = openCall(command);
    if (pending == nullptr) return turnedAway({Errc::TooManyCalls});
    const Refusal refusal = post(command, sent, pending->number, fill);
    if (refusal.error != Errc{}) return turnedAway(refusal);
    taken_[command].emplace_back();  // it uses a credit, and does not wait for it
    return whenAnswered(*pending, kj::mv(take));
  }

  /// Replaces the subscription.
  void subscribe(kj::Own<EventSink> sink, EventSet events, rt::ColumnSet columns);

 private:
  using Take = kj::Function<void(const std::byte*, Time)>;
  struct PendingCall {
    std::uint32_t number = 0;  // 0: free
    std::uint16_t command = 0;
    kj::Own<kj::PromiseFulfiller<void>> done;
    Take take = [](const std::byte*, Time) {};
  };
  using Taken = kj::Own<kj::PromiseFulfiller<void>>;
  struct Refusal {
    Errc error{};         // 0: there is none
    FieldPath invalid{};  // what is, of Errc::Invalid, as far as it was decoded
  };

  template <class Fill>
  Refusal post(std::uint16_t command, wire::Sent::Reader sent, std::uint32_t call,
               const Fill& fill) {
    if (const Errc error = errorOf(channel_->status.load(std::memory_order_acquire));
        error != Errc{}) {
      return {error};
    }
    const CommandInfo& info = channel_->info.commands[command];
    if (readOnly_ && !isRead(info.kind)) return {Errc::NotPermitted};
    const auto slot = channel_->commands.claim(command, stampOf(sent), call);
    if (!slot) return {slot.error()};
    Refusal refusal{fill(*slot)};
    if (refusal.error == Errc{} && !info.admits(*slot, &refusal.invalid)) {
      refusal.error = Errc::Invalid;
      channel_->lastInvalid.note(refusal.invalid);
    }
    if (refusal.error != Errc{}) {
      channel_->commands.abandon();
      return refusal;
    }
    channel_->commands.commit();
    channel_->ends.provider->ring();
    return {};
  }

  static bool isRead(CommandKind kind) {
    return kind == CommandKind::Read || kind == CommandKind::QualifiedRead;
  }

  kj::Promise<void> turnedAway(const Refusal& refusal);
  Time stampOf(wire::Sent::Reader sent) const;
  kj::Promise<void> whenTaken(std::uint16_t command);
  PendingCall* openCall(std::uint16_t command);
  kj::Promise<void> whenAnswered(PendingCall& call, Take take);

  void ending() override;
  void pump() override;
  void pumpCredits();
  void pumpTally();
  void pumpReplies();
  kj::Exception failureOf(const PendingCall& call, Errc error) const;
  void pumpEvents();
  void pumpRow();
  bool wanted(const rt::EventRecord& record) const;
  void sendEvent(EventSink& sink, const rt::EventRecord& record);
  void eventSent();
  void sendRow(EventSink& sink, const rt::StateTable::Row& row);
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

  kj::Maybe<kj::Own<EventSink>> sink_;
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
