#pragma once
// ChannelProvider is the provider's end of a channel.

#include <suture/component/channel/channel_words.h>
#include <suture/component/channel/lease.h>
#include <suture/component/channel/reply_record.h>
#include <suture/component/contract/interface_info.h>
#include <suture/rt/histogram.h>

#include <cstdint>
#include <memory>

namespace suture {

class Channel;

/// One thread uses it, except where a comment says otherwise: that of the component that provides,
/// or of the lane that carries what a client here has sent to another process.
class ChannelProvider {
 public:
  /// `keepsAges` says that the provider is a component in this process.
  ChannelProvider(Channel& channel, ChannelWords& words, Lease lease, bool keepsAges);

  /// Returns the events whose last value the client is to get now. Call it before you ask for the
  /// subscribed events.
  EventSet takeJoining();
  /// Returns true if takeJoining() has something to give.
  bool joining() const { return words_.joining.load(std::memory_order_relaxed) != 0; }
  /// Returns true if the client is to be rung for a row, credits or a tally.
  bool rowsAreWanted() const { return words_.wantsRows.isUp(std::memory_order_relaxed); }
  /// Returns the flag that is up if a reply or an event has been put in since the client last
  /// looked. A thread that lowers it must look for both before it sleeps.
  rt::SharedFlag& untaken() { return words_.untaken; }

  /// Call it just before a command is executed. Returns an error if the connection is over. If
  /// `present` is not null, it also returns one if the lease has ended by then, which ends the
  /// connection.
  Errc begin(const BootTime* present);
  /// Returns false if the client has cancelled `call`, which must not be executed then.
  bool claim(std::uint32_t call) { return words_.claim(call); }
  /// Answers `call` with an error.
  void replyError(std::uint32_t call, Errc error);
  /// Answers `call`; `produce(std::byte* result)` fills the result in place and returns an Errc, 0
  /// for success. `stamp` says when the result was produced.
  template <class Produce>
  void reply(std::uint32_t call, ResultForm form, const Produce& produce, Time stamp = now());

  /// Any thread. Says how long the client's commands may be executed.
  const Lease lease;
  /// It counts the ages of commands when they were executed. It is nullptr if the provider is
  /// elsewhere.
  const std::unique_ptr<rt::Histogram> commandAge;

 private:
  Channel& channel_;
  ChannelWords& words_;
};

}  // namespace suture
