#pragma once
// One connection with a delay, or with faults.

#include <suture/component/channel/channel.h>
#include <suture/lane/delay/calls_under_way.h>
#include <suture/lane/delay/connection_delay.h>
#include <suture/lane/delay/message_line.h>

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

namespace suture {

/// Carries everything between `near`, which the client uses, and `far`, which leads to the provider
/// over whatever lane. Belongs to the delay thread.
///
/// A command is due `delay.commands` after it was sent, and keeps its stamp: a ttl sees the delay.
/// What comes back is due `delay.answers` after it arrived here, and keeps its stamp too: a read's
/// age shows the delay. Credits, subscriptions and the first ask for a read are not
/// delayed, and neither these nor losses of the provider meet faults.
///
/// With faults, messages may be lost, come twice or out of order; docs/lanes.md says what holds all
/// the same. near->delivery counts what was noticed.
class DelayedConnection {
 public:
  DelayedConnection(std::shared_ptr<Channel> near, std::shared_ptr<Channel> far,
                    const ConnectionDelay& delay);

  /// Takes what has come and delivers what is due.
  void pump(Time now);
  /// When something is due next.
  Time due();
  /// True if credits are lent, since nobody may ring when the provider's end gives them back.
  bool awaitsCredits() const;
  /// True if the client has let go; there is nothing to carry any more.
  bool over() const;
  /// Tells both ends that nothing is carried any more.
  void end();

 private:
  void takeCommands();
  void sendMarks(Time now);
  bool expectsMarks() const;
  void deliverCommands(Time now);
  void deliver(const rt::CommandRecord& record);
  void returnCredits();
  void passDemandOn();
  void passSubscriptionsOn();
  void takeAnswers();
  void deliverAnswers(Time now);
  void deliverAnswer(const ReplyRecord& answer);
  void settleCalls(const CallsMark& mark);
  void refuse(std::uint32_t call, Errc error);
  void takeEvents();
  void deliverEvents(Time now);
  void takeRows();
  void keepRow(const rt::StateTable::Row& row, Time due);
  void deliverRows(Time now);
  void takeStatus();
  void deliverStatus(Time now);
  void countBytes();
  void countCommands();

  bool usesCredit(const rt::CommandRecord& record) const;

  const std::shared_ptr<Channel> near_, far_;
  const ConnectionDelay delay_;
  MessageLine commands_, answers_, events_, rows_;
  DelayLine statuses_;
  /// A command that uses a credit and may still arrive.
  struct Outstanding {
    std::uint64_t sequence;
    std::uint16_t command;
  };
  std::deque<Outstanding> outstanding_;  // as many as there are credits at most
  // By command: how many credits are used by what is under way here, and how many by that and by
  // what the provider has.
  std::vector<std::uint32_t> underWay_, lent_;
  CallsUnderWay calls_;
  // What was so when the last marks were sent, which the next ones say: what takes no longer than
  // the time between the two is not given up.
  std::uint64_t delivered_ = 0;  // commands
  std::uint64_t commandsSent_ = 0, answersSent_ = 0;
  CallsMark callsMark_{};
  Time nextMarks_{};
  std::uint64_t nextRow_ = 1;
  rt::ColumnSet asked_ = 0;
  std::vector<std::vector<std::uint64_t>> slots_;  // by column
  std::vector<std::byte*> slotPointers_;
  ChannelStatus status_ = ChannelStatus::Connected;  // as far as it has been taken
};

}  // namespace suture
