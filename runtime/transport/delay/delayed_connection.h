#pragma once
// One connection with a delay.

#include <suture/component/channel.h>
#include <suture/transport/delay/connection_delay.h>
#include <suture/transport/delay/delay_line.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace suture {

/// Carries everything between `near`, which the client uses, and `far`, which leads to the provider
/// over whatever lane. Belongs to the delay thread.
///
/// A command is due `delay.commands` after it was sent, and keeps its stamp: a ttl sees the delay.
/// What comes back is due `delay.answers` after it arrived here, and keeps its stamp too: a read's
/// age shows the delay. Credits, subscriptions and the first ask for a read are not
/// delayed.
class DelayedConnection {
 public:
  DelayedConnection(std::shared_ptr<Channel> near, std::shared_ptr<Channel> far,
                    const ConnectionDelay& delay);

  /// Takes what has come and delivers what is due.
  void pump(Time now);
  /// When something is due next.
  Time due();
  /// True if the provider's end has credits to give back, of which nobody may tell.
  bool awaitsCredits() const;
  /// True if the client has let go; there is nothing to carry any more.
  bool over() const;
  /// Tells both ends that nothing is carried any more.
  void end();

 private:
  void takeCommands();
  void deliverCommands(Time now);
  void deliver(const rt::CommandRecord& record);
  void returnCredits();
  void passDemandOn();
  void passSubscriptionsOn();
  void takeAnswers();
  void deliverAnswers(Time now);
  void takeEvents();
  void deliverEvents(Time now);
  void takeRows();
  void keepRow(const rt::StateTable::Row& row, Time due);
  void deliverRows(Time now);
  void takeStatus();
  void deliverStatus(Time now);
  void countBytes();

  bool usesCredit(const rt::CommandRecord& record) const;

  const std::shared_ptr<Channel> near_, far_;
  const ConnectionDelay delay_;
  DelayLine commands_, answers_, events_, rows_, statuses_;
  // By command: how many the client may not send yet since they are under way here, and how many in
  // all.
  std::vector<std::uint32_t> underWay_, lent_;
  std::uint64_t nextRow_ = 1;
  rt::ColumnSet asked_ = 0;
  std::vector<std::vector<std::uint64_t>> slots_;  // by column
  std::vector<std::byte*> slotPointers_;
  ChannelStatus status_ = ChannelStatus::Connected;  // as far as it has been taken
};

}  // namespace suture
