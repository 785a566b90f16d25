#pragma once
// This sums up a connection over all the channels that it has had.

#include <suture/component/channel/counts/channel_counts.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace suture {

class Channel;

/// A provider's process tells this of the channels that a connection had before.
struct Earlier {
  Tally tally;
  bool ended = false;  ///< they execute nothing any more, so these are the last counts
};

/// Counts what a client's end turned down at once, and so never accepted.
struct TurnedDown {
  std::uint64_t full = 0, tooLarge = 0, invalid = 0;
};

/// Says where the commands of a connection are: the accepted ones are those that `tally` counts,
/// those lost, those unknown and those under way, together.
struct Sums {
  std::uint64_t accepted = 0;  ///< client: from the component; provider: from the lane
  TurnedDown turnedDown;
  std::uint64_t eventsDelivered = 0;
  Tally tally;  ///< includes `heard`
  Tally heard;  ///< the part that the provider's process has told, as long as it is the same
                ///< process
  std::uint64_t lost = 0;          ///< never executed: they did not reach the provider in time
  std::uint64_t unknown = 0;       ///< client: the provider may have executed them
  std::uint64_t underWay = 0;      ///< they have no outcome yet
  std::uint64_t otherProcess = 0;  ///< the incarnation of the process at the other end
};

/// Any thread but a task's. Holds the sums of one end, as long as its connection has the same name.
/// They keep the counts of channels that are lost.
class Ledger {
 public:
  enum class History : std::uint8_t {
    Whole,
    Forgotten,  ///< there may have been channels that it does not know
  };

  explicit Ledger(ConnectionEnd end, History history = History::Whole)
      : end_(end), history_(history) {}

  /// From now on `channel` is the connection's, to a process of that incarnation. `earlier` is what
  /// that process tells of the channels before.
  void begin(const std::shared_ptr<Channel>& channel, std::uint64_t otherProcess,
             const Earlier& earlier = {});
  /// Client's end: adds news about the same earlier channels.
  void tell(const Earlier& earlier);
  /// Provider's end: returns what there is to tell of all channels but `latest`. These are never
  /// the last counts if the history is Forgotten.
  Earlier before(const Channel& latest);

  Sums sums() const;
  /// Returns false for a channel that another has followed.
  bool isLatest(const Channel& channel) const;
  /// Keeps only the sums of the channels that are gone. Their counts may lie in a block of memory
  /// that another process maps too, with all their queues.
  void letGo();

 private:
  /// Sums up several channels.
  struct Group {
    std::uint64_t accepted = 0, lost = 0, eventsDelivered = 0;
    TurnedDown turnedDown;
    Tally own, heard;
    Group operator+(const Group& other) const;
    std::uint64_t open() const;
  };
  struct Entry {
    std::weak_ptr<Channel> channel;
    std::shared_ptr<const ChannelCounts> counts;  // null: the channel is gone, and had `last`
    std::uint64_t otherProcess;
    Group last{};
  };

  struct Groups {
    Group gone, earlier, latest;
  };
  Groups groups() const;
  Group groupOf(const Entry& entry) const;
  /// Divides the commands without an outcome into lost, unknown and under way.
  void divideOpen(const Groups& all, const Channel* latest, Sums& sums) const;
  void fold();
  void leaveProcess();
  /// Client's end: returns how many commands never reached the present process, as it has said.
  std::uint64_t lostOf(const Groups& all) const;

  const ConnectionEnd end_;
  const History history_;
  mutable std::mutex mutex_;
  std::uint64_t otherProcess_ = 0;
  std::vector<Entry> entries_;  // oldest first; the last is the connection's
  // These sum up closed channels: those to processes that are gone, and those to the present one.
  Group gone_, ended_;
  std::uint64_t lostThere_ = 0, lostHere_ = 0;  // at processes that are gone, and at the present
                                                // one
  Earlier earlier_;                             // what the present one has told of all but the last
};

}  // namespace suture
