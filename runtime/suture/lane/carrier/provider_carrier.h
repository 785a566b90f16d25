#pragma once
// ProviderCarrier stands in for the client's end of a channel whose client is beyond a lane.

#include <suture/component/channel/channel.h>
#include <suture/lane/carrier/interest.h>
#include <suture/rt/counter.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace suture {

/// Only the lane's thread uses this. It puts the commands that arrive into the provider's channel
/// in their order, and sends what the provider answers, emits and publishes.
class ProviderCarrier {
 public:
  /// Stands for a command that the contract does not have.
  static constexpr std::uint16_t kUnknown = 0xffff;

  enum class Message : std::uint8_t { Reply, Credits, Tally, Event, Row };

  /// A Wire is what a lane implements to send what the provider has.
  class Wire {
   public:
    /// Returns true if one more such message may be sent.
    virtual bool hasRoom(Message message) const = 0;
    /// Sends an answer, which is unchanged until replySent(); that must be called before the next
    /// one.
    virtual void send(const ReplyRecord& reply) = 0;
    /// Says that the client may send that many more of the command that it gives this number.
    virtual void sendCredits(std::uint16_t command, std::uint32_t count) = 0;
    /// Sends the outcomes of all commands so far.
    virtual void send(const Tally& tally) = 0;
    /// Sends an event, which is unchanged until eventSent(); that must be called before the next
    /// one.
    virtual void send(const rt::EventRecord& event, std::uint32_t subscription) = 0;
    /// Sends the newest row, unless it is row `last`, and sets that to its number; it may send rows
    /// between the two as well. Returns true if it goes on at the next turn.
    virtual bool sendRow(rt::ColumnSet columns, std::uint64_t& last) = 0;

   protected:
    ~Wire() = default;
  };

  /// `channel` and `wire` outlive this. `commands` maps the number that the client gives a command
  /// to its number here, or to kUnknown; it is empty if all numbers are the same.
  ProviderCarrier(Channel& channel, Wire& wire, std::vector<std::uint16_t> commands = {});

  /// From now on accepts only reads: a command is refused (Errc::NotPermitted).
  void setReadOnly() { readOnly_ = true; }

  // --- from the client

  /// Returns the number here of a command that the client gives this number.
  std::uint16_t commandAt(std::uint16_t theirs) const {
    return theirs < commands_.size() ? commands_[theirs] : kUnknown;
  }
  std::size_t commands() const { return commands_.size(); }
  /// Notes that a command of this number uses a credit, which goes back to the client when the
  /// command has been taken, or never will be.
  void lend(std::uint16_t theirs) { ++waiting_[theirs]; }

  /// Says why a command was not put in.
  struct Refusal {
    Errc error{};         ///< 0 if it was put in
    FieldPath invalid{};  ///< the invalid part, for Errc::Invalid
  };
  /// Puts in a command, and checks its arguments before the provider sees them. `decode(std::byte*
  /// arguments)` fills them in and returns an Errc, 0 for success. Does not count a refused
  /// command.
  template <class Decode>
  Refusal post(std::uint16_t command, Time stamp, std::uint32_t call, const Decode& decode);
  /// Counts a command that was not put in.
  void countRefused() { rt::increment(channel_.counts->turnedAway); }
  void subscribe(const Interest& interest);
  /// Wakes the provider for what has come.
  void ringProvider();

  // --- to the client

  /// Sends everything that waits, as far as the wire has room. Returns true if it goes on at the
  /// next turn.
  bool give();
  void giveReplies();
  void giveTally();
  void giveEvents();
  bool giveRow();
  /// The wire calls these when it has sent what it got.
  void replySent() { channel_.client.popReply(); }
  void eventSent() { channel_.events.pop(); }

 private:
  Errc whyNot(std::uint16_t command) const;
  void giveCredits();
  bool wanted(const rt::EventRecord& record) const;

  Channel& channel_;
  Wire& wire_;
  bool readOnly_ = false;
  bool work_ = false;  // the provider is to be rung
  const std::vector<std::uint16_t> commands_;
  std::vector<std::uint32_t> waiting_;  // by the client's number of a command: credits that the
                                        // client has not got back
  Tally tally_;                         // as the client has been told
  std::uint32_t subscription_ = 0;
  std::vector<Time> since_;  // by event: when it was joined anew, if it was
  rt::ColumnSet columns_ = 0;
  std::uint64_t lastRow_ = 0;
};

template <class Decode>
ProviderCarrier::Refusal ProviderCarrier::post(std::uint16_t command, Time stamp,
                                               std::uint32_t call, const Decode& decode) {
  if (const Errc error = whyNot(command); error != Errc{}) return {error};
  const auto slot = channel_.commands.claim(command, stamp, call);
  if (!slot) return {slot.error()};
  Refusal refusal{decode(*slot)};
  if (refusal.error == Errc{} && !channel_.info.commands[command].admits(*slot, &refusal.invalid)) {
    refusal.error = Errc::Invalid;
    channel_.lastInvalid.note(refusal.invalid);
  }
  if (refusal.error == Errc{}) {
    channel_.countSent(channel_.commands.commit());
    work_ = true;
  } else {
    channel_.commands.abandon();
  }
  return refusal;
}

}  // namespace suture
