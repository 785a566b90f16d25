#pragma once
// ClientCarrier stands in for the provider's end of a channel whose provider is beyond a lane.

#include <suture/component/channel/channel.h>
#include <suture/lane/carrier/interest.h>
#include <suture/rt/counter.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace suture {

/// Only the lane's thread uses this. It sends what a client has put into its channel, and puts
/// there what comes from the provider.
class ClientCarrier {
 public:
  enum class Message : std::uint8_t { Interest, Command };

  /// A Wire is what a lane implements to send what the client has.
  class Wire {
   public:
    /// Returns true if one more such message may be sent.
    virtual bool hasRoom(Message message) const = 0;
    virtual void send(const Interest& interest) = 0;
    /// Sends a command, which is unchanged until commandSent(); that must be called before the next
    /// one.
    virtual void send(const rt::CommandRecord& command) = 0;

   protected:
    ~Wire() = default;
  };

  /// The provider's channel has been made with the subscriptions of `channel`. Both outlive this.
  ClientCarrier(Channel& channel, Wire& wire);

  // --- to the provider

  /// Sends what there is, as far as there is room.
  void give();
  /// Call it when the wire has sent the command that it got.
  void commandSent() { channel_.commands.pop(); }
  /// Counts a command that the wire could not send; the provider will never know of it.
  void countRefused() { rt::increment(channel_.commands.counters.refused); }
  /// Call it instead of commandSent() if the wire knows that before; it counts the command.
  void refuse(const rt::CommandRecord& command, Errc error);

  // --- from the provider

  /// Returns the command whose answer `call` awaits, or none if no answer to it is awaited.
  std::optional<std::uint16_t> commandOf(std::uint32_t call) const;
  /// Passes an answer on, unless it is not awaited. `produce(std::byte* result)` fills in the
  /// result and returns an Errc, 0 for success.
  template <class Produce>
  void reply(std::uint32_t call, Time stamp, const Produce& produce);
  /// Does the same with an error, or with the bytes of a result of the right size.
  void reply(std::uint32_t call, Time stamp, Errc error, std::span<const std::byte> result);
  void replyError(std::uint32_t call, Errc error) { reply(call, now(), error, {}); }
  /// Passes on an event that was emitted for `subscription`, unless the client has joined it anew
  /// since. Returns false if the contract does not admit the payload.
  bool event(std::uint16_t event, std::uint32_t subscription, Time stamp, const std::byte* payload);
  /// Publishes a row. Its values are `values`, or lie in the draft of the channel's state if there
  /// are none. A reader checks what it reads of it.
  void row(Time stamp, rt::RowColumns columns, std::span<const rt::StateTable::Value> values = {});
  /// Gives that many credits back, because the commands have been taken. Returns false if fewer are
  /// under way.
  bool credits(std::uint16_t command, std::uint32_t count);
  /// Takes over what the provider's end has counted.
  void tally(const Tally& tally);
  /// Wakes the client for what has come.
  void ringClient();

 private:
  struct Call {
    std::uint32_t number = 0;  // 0: none
    std::uint16_t command = 0;
  };

  void giveSubscription();
  void giveCommands();
  bool begin(const rt::CommandRecord& command);
  void giveBack(std::uint16_t command, std::uint32_t count);
  void tellLane();
  Call& placeOf(std::uint32_t call) { return calls_[call % calls_.size()]; }

  Channel& channel_;
  Wire& wire_;
  EventSet events_;  // which the provider knows of
  rt::ColumnSet columns_ = 0;
  std::uint32_t subscription_ = 0;    // how many have been sent
  std::vector<std::uint32_t> since_;  // by event: the subscription that began it
  std::array<Call, Channel::kMaxCalls> calls_;
  std::vector<std::uint32_t> lent_;      // by command: how many use a credit
  bool arrival_ = false, news_ = false;  // the client is to be rung for
};

template <class Produce>
void ClientCarrier::reply(std::uint32_t call, Time stamp, const Produce& produce) {
  Call& place = placeOf(call);
  if (place.number != call) return;
  const CommandInfo& command = channel_.info.commands[place.command];
  channel_.provider.reply(call, {command.resultSize, command.sharedResult, place.command}, produce,
                          stamp);
  place.number = 0;
  arrival_ = true;
}

}  // namespace suture
