#pragma once
// The provider endpoint of a channel whose provider is beyond a lane.

#include <suture/component/channel/channel.h>
#include <suture/lane/carrier/interest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace suture {

/// Sends what a client has put into its channel, and puts there what comes from its provider. One
/// thread, the lane's.
class ClientCarrier {
 public:
  /// How a lane sends it.
  class Wire {
   public:
    /// True if one more message may be sent.
    virtual bool hasRoom() const = 0;
    virtual void send(const Interest& interest) = 0;
    /// The command stays as it is until commandSent(), which has to come before the next one.
    virtual void send(const rt::CommandRecord& command) = 0;

   protected:
    ~Wire() = default;
  };

  /// The provider's channel has been made with what `channel` is subscribed to. Both outlive this.
  ClientCarrier(Channel& channel, Wire& wire);

  // --- to the provider

  /// Sends what there is, as far as there is room.
  void give();
  /// The command that the wire got has left.
  void commandSent() { channel_.commands.pop(); }

  // --- from the provider

  /// Returns the command that `call` has asked an answer of; none if no answer to it is awaited.
  std::optional<std::uint16_t> commandOf(std::uint32_t call) const;
  /// The answer to a call, which is dropped if it is not awaited. `produce(std::byte* result)`
  /// fills in the result and returns an Errc, 0 for success.
  template <class Produce>
  void reply(std::uint32_t call, Time stamp, const Produce& produce);
  /// The same of a call that has no result.
  void replyError(std::uint32_t call, Errc error);
  /// An event that was emitted for `subscription`: dropped if that is an earlier one than the
  /// client's present wish for it. False: the contract does not admit the payload.
  bool event(std::uint16_t event, std::uint32_t subscription, Time stamp, const std::byte* payload);
  /// A row: what it does not bring in `values` lies in the draft of the channel's state. A reader
  /// judges what it reads of it.
  void row(Time stamp, rt::RowColumns columns, std::span<const rt::StateTable::Value> values = {});
  /// So many commands have been taken; false if there are not so many under way.
  bool credits(std::uint16_t command, std::uint32_t count);
  /// What the provider's end has counted.
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
  void tellLane();
  Call& placeOf(std::uint32_t call) { return calls_[call % calls_.size()]; }

  Channel& channel_;
  Wire& wire_;
  EventSet events_;  // that the provider has been told of
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
  channel_.reply(call, {command.resultSize, command.sharedResult, place.command}, produce, stamp);
  place.number = 0;
  arrival_ = true;
}

}  // namespace suture
