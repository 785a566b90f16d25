#pragma once
// A channel is everything between a client's end and its provider's end within a process. On the
// local lane two tasks share one channel; every other lane carries what it finds in one channel to
// another.

#include <suture/base/arena.h>
#include <suture/base/slots/shared_slot.h>
#include <suture/component/channel/channel_client.h>
#include <suture/component/channel/channel_provider.h>
#include <suture/component/channel/channel_status.h>
#include <suture/component/channel/channel_words.h>
#include <suture/component/channel/counts/channel_counts.h>
#include <suture/component/channel/direct_handlers.h>
#include <suture/component/channel/last_invalid.h>
#include <suture/component/channel/peer_state.h>
#include <suture/component/contract/connection_contract.h>
#include <suture/component/contract/interface_info.h>
#include <suture/rt/doorbell.h>
#include <suture/rt/queue/event_queue.h>
#include <suture/rt/queue/mailbox.h>
#include <suture/rt/queue/spsc_ring.h>
#include <suture/rt/state/state_table.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace suture {

class Ledger;
class ProvidedBase;

/// Each end is one thread, and neither waits for the other. The client's end puts into `commands`
/// and takes from `replies`, `events` and `state`; the provider's end does the opposite. What only
/// one of them does is in `client` and `provider`.
class Channel {
 public:
  static constexpr unsigned kMaxCalls = ChannelWords::kMaxCalls;

  struct Ends {
    /// The other end rings it with Arrival for a reply or an event, and with Work for all else.
    std::shared_ptr<rt::Doorbell> client;
    std::shared_ptr<rt::Doorbell> provider;  ///< is rung when commands are there
    /// Says which ends are this process's own; a lane stands in for the other one.
    ConnectionEnd components = ConnectionEnd::Both;
    ProvidedBase* device = nullptr;  ///< a device in this process, which the client calls directly
    /// This is the provider in this process, for what runs in the caller's thread.
    ProvidedBase* here = nullptr;
    /// The channel rings it too when the status changes, so that its owner can tell another
    /// process.
    std::shared_ptr<rt::Doorbell> watcher = nullptr;
    /// The process at the other end has this state; nullptr: it is this one, or a client that says
    /// nothing.
    std::shared_ptr<const PeerState> peer = nullptr;
    /// Says how long the client bears its provider's silence; 0: for ever, or it has not said so.
    Duration silence{0};
    /// A client that maps the provider's table asks for these columns.
    std::shared_ptr<const std::atomic<rt::ColumnSet>> asked = nullptr;
  };

  /// Both ends settle these terms before a connection has a channel.
  struct Terms {
    std::string name;  ///< "console:Teleop/Slave -> psm-host:PSM/Arm"
    /// Lists, in order, the commands of the contract that the provider does not have: optional
    /// ones, or those that the contract got after the provider was built.
    std::vector<std::uint16_t> lacking = {};
    /// Watches the connection's contract; nullptr: the connection has none.
    std::shared_ptr<ConnectionWatch> watch = nullptr;
    /// Sums over all the channels of the connection; nullptr: this is the only one.
    std::shared_ptr<Ledger> ledger = nullptr;
    /// Says why no faster lane that was hoped for is used; "" if none was.
    std::string laneReason = {};
  };

  /// `state` is the provider's table or, at the near end of a lane, the mirror; `subscribed` has
  /// the events that the client wants; `lane` is its name, for people. In foreign memory each
  /// process has its own object, and uses one of its two ends.
  Channel(const InterfaceInfo& info, Terms terms, std::string lane, Ends ends,
          std::shared_ptr<rt::StateTable> state, EventSet subscribed, Arena memory = {});
  ~Channel();
  /// Returns how much memory it needs.
  static std::size_t bytesFor(const InterfaceInfo& info);
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  const InterfaceInfo& info;
  const Terms terms;
  const std::string& name() const { return terms.name; }
  /// Parts the two ends in the name of a connection.
  static constexpr std::string_view kArrow = " -> ";
  /// Return the client's part of that name, and the provider's.
  std::string_view clientName() const {
    return std::string_view(name()).substr(0, name().rfind(kArrow));
  }
  std::string_view providerName() const {
    return std::string_view(name()).substr(name().rfind(kArrow) + kArrow.size());
  }
  /// Returns the part of either name that names the component: "console:Teleop".
  static constexpr std::string_view componentOf(std::string_view interface) {
    return interface.substr(0, interface.rfind('/'));
  }
  const std::string lane;
  const Ends ends;
  const std::shared_ptr<rt::StateTable> state;
  /// True if the other end is another process, which may write anything at any time: copy what
  /// comes from it, and check the copy.
  const bool foreign;

 private:
  const std::shared_ptr<ChannelWords> words_;

 public:
  rt::Mailbox commands;
  rt::SpscRing replies;
  rt::EventQueue events;
  const std::shared_ptr<ChannelCounts> counts;
  DirectHandlers direct;  ///< used where both ends share a process and no delay lies between
  std::atomic<ChannelStatus> status{ChannelStatus::Connected};
  std::atomic<Time> statusSince{now()};
  /// Counts how often the status has become Faulted: a provider may be restarted before anyone
  /// looks.
  std::atomic<std::uint32_t> faults{0};
  /// Counts the calls of this client that ended at their deadline while the provider's component
  /// had a command at the client's own component.
  std::atomic<std::uint32_t> mutualWaits{0};
  std::atomic<std::uint64_t> bytesSent{0}, bytesReceived{0};  ///< on the lane's wire; 0 on `local`
  LastInvalid lastInvalid;  ///< the latest value that this process refused, at either end

  ChannelClient client;
  ChannelProvider provider;

  /// Any thread. Returns false for arguments, a result or a payload that the contract does not
  /// admit, and notes which part of it that is.
  bool admits(const CommandInfo& command, const std::byte* arguments);
  bool admitsResult(const CommandInfo& command, const std::byte* result);
  /// Does the same for a copy, which the provider can no longer change.
  bool admitsCopy(const CommandInfo& command, const std::byte* result);
  bool admits(const EventInfo& event, const std::byte* payload);

  /// These count, beside what the queues add, what this end has put into foreign memory or taken
  /// out of it, because no lane counts there.
  void countSent(std::size_t bytes) { count(bytesSent, bytes); }
  void countReceived(std::size_t bytes) { count(bytesReceived, bytes); }

  /// Any thread. Returns what is added to the stamps of the other end to have them on this
  /// process's clock. It is zero if both have one clock.
  Duration clockShift() const {
    if (ends.peer == nullptr) return Duration{0};
    return ends.peer->clockShift.load(std::memory_order_relaxed);
  }
  /// Any thread. Returns how wrong that, and so an age, may be, either way, until the clocks are
  /// compared again. If they are not, the connection is lost by then.
  Duration clockError() const;

  /// Either end. Returns the events that the client wants.
  EventSet subscribed() const { return words_->subscribed.load(std::memory_order_acquire); }
  /// Any thread. Sets the status of the provider, unless the connection is over, and rings the
  /// client if the status is new.
  void tell(ChannelStatus news);
  /// Notes since when a status holds that was changed without tell().
  void noteStatus(ChannelStatus news);

 private:
  void count(std::atomic<std::uint64_t>& counter, std::size_t bytes) const {
    if (foreign) counter.fetch_add(bytes, std::memory_order_relaxed);
  }
};

template <class Produce>
void ChannelProvider::reply(std::uint32_t call, ResultForm form, const Produce& produce,
                            Time stamp) {
  rt::SpscRing& replies = channel_.replies;
  // There is room for an answer to every call, unless a foreign client says otherwise.
  std::byte* memory = replies.claim(sizeof(ReplyRecord) + form.size);
  if (memory == nullptr) return;
  auto* record = new (memory) ReplyRecord{stamp, call, Errc{}, form.shared, form.command};
  if (form.shared) putSharedSlot(record->result(), nullptr);
  try {
    record->error = produce(record->result());
  } catch (...) {
    if (form.shared) releaseSharedSlot(record->result());
    throw;
  }
  replies.commit();
  channel_.countSent(rt::SpscRing::recordSize(sizeof(ReplyRecord) + form.size));
}

/// Returns for each column which parts of it need not be copied.
std::vector<BoundedLevels> columnLevels(const InterfaceInfo& info);

/// Returns a contract's state table, with one column for each read. `readers` says if another
/// process may map it. It has at least `rows` rows; 0: as many as their size suggests.
std::shared_ptr<rt::StateTable> makeStateTable(const InterfaceInfo& info,
                                               rt::StateTable::Readers readers, unsigned rows = 0);

}  // namespace suture
