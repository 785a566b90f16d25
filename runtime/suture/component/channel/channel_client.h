#pragma once
// ChannelClient is the client's end of a channel.

#include <suture/component/channel/channel_words.h>
#include <suture/component/channel/counts/delivery_counters.h>
#include <suture/component/channel/reply_record.h>
#include <suture/component/contract/interface_info.h>
#include <suture/rt/histogram.h>
#include <suture/standard/lifecycle.h>

#include <cstdint>
#include <memory>

namespace suture {

class Channel;

/// One thread uses it, except where a comment says otherwise: that of the component that requires,
/// or of the lane that brings what a client in another process has sent.
class ChannelClient {
 public:
  /// `keepsAges` says that the client is a component in this process.
  ChannelClient(Channel& channel, ChannelWords& words, bool keepsAges);

  /// Subscribes to `wanted`, and asks first for the last values of the latched ones among
  /// `newlyWanted`. The caller rings the provider. Commands that are sent later are executed after
  /// that.
  void subscribe(EventSet wanted, EventSet newlyWanted);
  /// Makes rows, credits and tallies ring as well, because a lane leads from here to the client.
  void askForRows() { words_.wantsRows.raise(); }

  /// Returns the oldest answer, or nullptr.
  ReplyRecord* nextReply();
  /// Drops it, and its result unless that has been moved elsewhere and is null now.
  void popReply();
  /// Call it before you look for answers and events: then the provider rings for whatever it puts
  /// in later.
  void lowerUntaken() {
    if (words_.untaken.isUp(std::memory_order_relaxed)) {
      words_.untaken.take(std::memory_order_acq_rel);
    }
  }
  /// Returns true if the provider will not execute `call`, and answers so.
  bool cancel(std::uint32_t call) { return words_.claim(call); }

  /// Any thread, before the client is told that the connection is over. If both share memory, the
  /// provider then begins no more of its commands.
  void cut() { words_.cut.raise(); }
  /// Any thread. Ends the connection, and rings the provider, which drops it in its own time.
  void close();
  /// Any thread. Admits commands that await their operator again, if the provider is there.
  ResumeOutcome resume();

  /// It counts the ages of values when they were read: of each row when it is first read, and of
  /// every 16th read of a row that has been read before. It is nullptr if the client is no
  /// component here.
  const std::unique_ptr<rt::Histogram> readAge;
  DeliveryCounters delivery;  ///< both ways; all 0 on a lane that loses nothing

 private:
  static ReplyRecord* makePossible(std::byte* memory);

  Channel& channel_;
  ChannelWords& words_;
};

}  // namespace suture
