#pragma once
// The client's side of an rpc connection: the provider endpoint of a channel, emptied into remote
// calls.

#include <kj/async.h>
#include <suture/base/slots/shared_slot.h>
#include <suture/component/channel/channel.h>
#include <suture/framing/message_stream.h>
#include <suture/framing/remote_error.h>
#include <suture/lane/client_end.h>
#include <suture/lane/rpc/binding.h>
#include <suture/loop/control_thread.h>
#include <suture/wire/wire.h>

#include <memory>
#include <span>
#include <vector>

namespace suture::rpc {

/// Takes the commands of one client out of its mailbox in their order and sends each as a call;
/// puts answers, events and rows that arrive where the client looks for them. Belongs to the
/// control thread; shared by the connection and by the capability that receives events.
class ProxyPort final : public ClientEnd, private Pump, private kj::TaskSet::ErrorHandler {
 public:
  /// With so many newest-wins commands under way, the next wait in their cells, where newer ones
  /// replace them.
  static constexpr unsigned kWindow = 16;

  /// `channel`'s provider doorbell is the control thread's, its state table a mirror that this
  /// writes.
  ProxyPort(ControlThread& control, std::shared_ptr<Channel> channel,
            std::shared_ptr<const LinkCounters> counters);
  ~ProxyPort() noexcept(false);

  /// Begins: subscribes and sends what waits.
  void open(kj::Own<Proxy> proxy);
  void noteReplay(std::uint16_t event, std::int64_t stamp) override;

  // --- for generated code

  /// Turns the peer's steady clock into this process's.
  Duration shift() const { return channel_->clockShift(); }

  /// Answers call `call`: `produce(Slot&)` converts the result and returns an Errc. `stamp`: when
  /// the provider produced it, on its clock, ns; 0: not said.
  template <class Slot, class Produce>
  void answer(std::uint32_t call, std::int64_t stamp, const Produce& produce) {
    reply(
        call, {slotSize<Slot>, ownsMemory<Slot>},
        [&](std::byte* slot) { return produce(newSlot<Slot>(slot)); }, here(stamp));
  }
  template <class Slot, class Produce>
  void answer(std::uint32_t call, const Produce& produce) {
    answer<Slot>(call, 0, produce);
  }
  /// Answers a call without a result; 0: nobody asked for an answer.
  void answer(std::uint32_t call) {
    if (call != 0) reply(call, {}, [](std::byte*) { return Errc{}; });
  }

  /// Reads the two sets of a row that has come: a column that the contract does not admit is in
  /// both.
  static rt::RowColumns columnsOf(rt::ColumnSet evaluated, rt::ColumnSet tooLarge) {
    return {.valid = evaluated & ~tooLarge,
            .tooLarge = tooLarge & ~evaluated,
            .invalid = evaluated & tooLarge};
  }
  /// The slot of column `column` in the next row.
  template <class Slot>
  Slot& column(unsigned column) {
    return newSlot<Slot>(channel_->state->draft(column));
  }
  /// Publishes the slots of column(), and why others have no value; `stamp` is on the provider's
  /// clock, ns.
  void publish(std::int64_t stamp, const rt::RowColumns& columns);

  /// Hands an event to the client: `decode(Slot&)` converts the payload and returns an Errc. The
  /// promise is the answer to the provider; see acknowledge().
  template <class Slot, class Decode>
  kj::Promise<void> event(std::uint16_t event, const Decode& decode) {
    LooseSlot<Slot> payload;
    if (const Errc error = decode(payload.value()); error != Errc{}) return remoteError(error);
    if (!channel_->admits(channel_->info.events[event], payload.memory())) {
      return remoteError(Errc::Invalid, channel_->lastInvalid.read());
    }
    push(event, payload.memory());
    return acknowledge();
  }
  kj::Promise<void> event(std::uint16_t event) {
    push(event, nullptr);
    return acknowledge();
  }

 private:
  template <class Produce>
  void reply(std::uint32_t call, ResultForm form, const Produce& produce, Time stamp = now()) {
    if (isClosed()) return;
    channel_->reply(call, form, produce, stamp);
    channel_->ends.client->ring(rt::RungFor::Arrival);
  }

  Time here(std::int64_t stamp) const;
  void push(std::uint16_t event, const std::byte* slot);
  /// The newest event is answered with the next command, or when another event arrives: a message
  /// of its own would cost both processes a wake-up, and the provider does not wait for it before
  /// ServantPort::kWindow of them.
  kj::Promise<void> acknowledge();
  void releaseAcknowledgement();
  void ending() override;
  void pump() override;
  void countBytes();
  void pumpSubscription();
  void leave(EventSet events);
  void subscribe(EventSet events, rt::ColumnSet columns);
  void pumpCommands();
  void transmit(const rt::CommandRecord& record);
  void returned(std::uint16_t command, std::uint32_t call, Errc error);
  void taskFailed(kj::Exception&& exception) override;

  ControlThread& control_;
  const std::shared_ptr<const LinkCounters> counters_;
  kj::Maybe<kj::Own<Proxy>> proxy_;
  unsigned latestInFlight_ = 0;
  EventSet events_ = 0;
  rt::ColumnSet columns_ = 0;
  std::vector<std::int64_t> replays_;  // by event: what noteReplay() told; 0: it did not
  EventSet leaving_ = 0;            // what of these comes was emitted for an earlier subscription
  unsigned farewellsUnderWay_ = 0;  // messages after whose answer no more of it comes
  kj::Maybe<kj::Own<kj::PromiseFulfiller<void>>> acknowledgement_;
  kj::TaskSet calls_;  // last: cancelled first
};

}  // namespace suture::rpc
