#pragma once
// This is one connection with a delay, or with faults.

#include <suture/lane/carrier/client_carrier.h>
#include <suture/lane/carrier/provider_carrier.h>
#include <suture/lane/carrier/row_slots.h>
#include <suture/lane/delay/calls_under_way.h>
#include <suture/lane/delay/connection_delay.h>
#include <suture/lane/delay/message_line.h>

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

namespace suture {

/// Belongs to the delay thread. Carries everything between `near`, which the client uses, and
/// `far`, which leads to the provider over whatever lane.
///
/// A command is due `delay.commands` after it was sent, and keeps its stamp, so a ttl sees the
/// delay. An answer is due `delay.answers` after it arrived here, and keeps its stamp too, so a
/// read's age shows the delay. Credits, subscriptions and the first request for a read are not
/// delayed. Faults strike neither these nor the news that the provider is lost.
///
/// With faults, messages may be lost, come twice or out of order; docs/lanes.md says what still
/// holds. near->client.delivery counts what was noticed.
class DelayedConnection final : private ClientCarrier::Wire, private ProviderCarrier::Wire {
 public:
  DelayedConnection(std::shared_ptr<Channel> near, std::shared_ptr<Channel> far,
                    const ConnectionDelay& delay);

  /// Takes what has come and delivers what is due.
  void pump(Time now);
  /// Returns when something is due next.
  Time due();
  /// Returns true if the client has closed the connection, so there is nothing to carry any more.
  bool over() const;
  /// Tells both ends that nothing is carried any more.
  void end();

 private:
  using Message = ProviderCarrier::Message;

  // The client's carrier sends by these, and the deliver functions take what arrives.
  bool hasRoom(ClientCarrier::Message message) const override {
    return message == ClientCarrier::Message::Interest || commands_.hasRoom();
  }
  void send(const Interest& interest) override;
  void send(const rt::CommandRecord& command) override;
  void deliverCommands(Time now);
  void deliver(const rt::CommandRecord& command);
  void giveUp(std::uint64_t sequence);

  // The provider's carrier sends by these.
  bool hasRoom(Message message) const override;
  void send(const ReplyRecord& reply) override;
  void sendCredits(std::uint16_t command, std::uint32_t count) override;
  void send(const Tally&) override {}  // countCommands() reads all that there is
  void send(const rt::EventRecord& event, std::uint32_t subscription) override;
  bool sendRow(rt::ColumnSet columns, std::uint64_t& last) override;
  void keepRow(const rt::StateTable::Row& row, Time due);
  void takeStatus();
  /// Returns false if there is no room for it now.
  bool takeStatus(ChannelStatus status);
  void deliverAnswers(Time now);
  void deliverAnswer(const ReplyRecord& answer);
  void deliverEvents(Time now);
  void deliverRows(Time now);
  void deliverStatus(Time now);

  // These settle what may have been lost.
  bool expectsMarks() const;
  void sendMarks(Time now);
  void settleCalls(const CallsMark& mark);

  void countBytes();
  void countCommands();

  const std::shared_ptr<Channel> near_, far_;
  const ConnectionDelay delay_;
  MessageLine commands_, answers_, events_, rows_;
  DelayLine statuses_;
  /// This is a command that uses a credit and may still arrive.
  struct Outstanding {
    std::uint64_t sequence;
    std::uint16_t command;
  };
  std::deque<Outstanding> outstanding_;  // at most as many as there are credits
  CallsUnderWay calls_;
  // These hold the state at the last marks, because the next marks tell that state and not the
  // present one: so a message that takes no longer than from one mark to the next is not given up.
  std::uint64_t delivered_ = 0;  // commands
  std::uint64_t commandsSent_ = 0, answersSent_ = 0;
  CallsMark callsMark_{};
  Time nextMarks_{};
  std::uint64_t nextRow_ = 1;
  RowSlots row_;                                     // the row that is being taken
  std::vector<rt::StateTable::Value> values_;        // those that are delivered as one row
  ChannelStatus status_ = ChannelStatus::Connected;  // the last status that was taken
  std::uint32_t faultsTaken_ = 0;                    // how many of the provider's were taken
  ClientCarrier client_;
  ProviderCarrier provider_;
};

}  // namespace suture
