#pragma once
// Everything between a client's end and its provider's end within a process. The local lane
// is one channel shared by two tasks; every other lane carries what it finds in one channel to
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

/// Each end is one thread, and neither waits for the other. The client's end produces into
/// `commands` and consumes `replies`, `events` and `state`; the provider's end is the other side of
/// each. What only one of them does is in `client` and `provider`.
class Channel {
 public:
  static constexpr unsigned kMaxCalls = ChannelWords::kMaxCalls;

  struct Ends {
    /// It is rung with Arrival for a reply or an event, and with Work for all else.
    std::shared_ptr<rt::Doorbell> client;
    std::shared_ptr<rt::Doorbell> provider;  ///< it is rung when commands are there
    /// These ends are this process's own; a lane plays the other one.
    ConnectionEnd components = ConnectionEnd::Both;
    ProvidedBase* device = nullptr;  ///< of a device in this process: the client calls it directly
    ProvidedBase* here = nullptr;    ///< in this process, for what runs in the caller's thread
    /// It is rung too when the status changes, so that its owner can tell another process.
    std::shared_ptr<rt::Doorbell> watcher = nullptr;
    /// The process at the other end; nullptr: it is this one, or a client that says nothing.
    std::shared_ptr<const PeerState> peer = nullptr;
    /// How long the client bears its provider's silence; 0: for ever, or it has not said so.
    Duration silence{0};
    /// The columns that a client which maps the provider's table asks of it.
    std::shared_ptr<const std::atomic<rt::ColumnSet>> asked = nullptr;
  };

  /// These are settled before a connection has a channel.
  struct Terms {
    std::string name;  ///< "console:Teleop/Slave -> psm-host:PSM/Arm"
    /// The commands of the contract that the provider does not have, in their order: optional ones,
    /// or those that the contract got after the provider was built.
    std::vector<std::uint16_t> lacking = {};
    /// Watches the connection's contract; nullptr: the connection has none.
    std::shared_ptr<ConnectionWatch> watch = nullptr;
    /// Sums over all the channels of the connection; nullptr: this is the only one.
    std::shared_ptr<Ledger> ledger = nullptr;
    /// Why it is not a faster lane that had been hoped for; "" if there was none.
    std::string laneReason = {};
  };

  /// `state`: the provider's table or, at the near end of a lane, the mirror. `subscribed`: the
  /// events the client wants. `lane`: its name, for people. In foreign memory each process has an
  /// object of its own, and uses one of its two ends.
  Channel(const InterfaceInfo& info, Terms terms, std::string lane, Ends ends,
          std::shared_ptr<rt::StateTable> state, EventSet subscribed, Arena memory = {});
  ~Channel();
  /// How much memory it needs.
  static std::size_t bytesFor(const InterfaceInfo& info);
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  const InterfaceInfo& info;
  const Terms terms;
  const std::string& name() const { return terms.name; }
  /// The client's part of that name.
  std::string_view clientName() const {
    return std::string_view(name()).substr(0, name().rfind(" -> "));
  }
  const std::string lane;
  const Ends ends;
  const std::shared_ptr<rt::StateTable> state;
  /// The other end is another process, which may write anything at any time: copy what comes from
  /// it, and believe nothing in the copy.
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
  /// How often the status has become Faulted: a provider may be restarted before anybody looks.
  std::atomic<std::uint32_t> faults{0};
  std::atomic<std::uint64_t> bytesSent{0}, bytesReceived{0};  ///< on the lane's wire; 0 on `local`
  LastInvalid lastInvalid;  ///< of what this process judged, at either end

  ChannelClient client;
  ChannelProvider provider;

  /// Any thread: false for arguments, a result or a payload that the contract does not admit; then
  /// notes which part of it that is.
  bool admits(const CommandInfo& command, const std::byte* arguments);
  bool admitsResult(const CommandInfo& command, const std::byte* result);
  /// The same of a copy, which the provider can no longer change.
  bool admitsCopy(const CommandInfo& command, const std::byte* result);
  bool admits(const EventInfo& event, const std::byte* payload);

  /// Counts what this end has put into foreign memory, or taken out of it, with what the
  /// queues add: no lane is there that counts.
  void countSent(std::size_t bytes) { count(bytesSent, bytes); }
  void countReceived(std::size_t bytes) { count(bytesReceived, bytes); }

  /// Any thread: what is added to the stamps of the other end, to have them on this process's
  /// clock. Zero where both have one.
  Duration clockShift() const {
    if (ends.peer == nullptr) return Duration{0};
    return ends.peer->clockShift.load(std::memory_order_relaxed);
  }
  /// Any thread: how wrong that, and so an age, may be, either way, until the clocks are compared
  /// again; without that, the connection is lost by then.
  Duration clockError() const;

  /// Either end: returns the events that the client wants.
  EventSet subscribed() const { return words_->subscribed.load(std::memory_order_acquire); }
  /// Any thread: sets how it stands with the provider, unless the connection is past that, and
  /// rings the client if that is news.
  void tell(ChannelStatus news);
  /// Notes a status that was changed without tell(), for the trace of a stepped clock.
  void noteStatus(ChannelStatus news) const;

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

/// Tells by column what need not be copied of it.
std::vector<BoundedLevels> columnLevels(const InterfaceInfo& info);

/// A contract's state table: one column a read. `readers`: whether another process may map it.
/// `rows`: at least so many; 0: as many as their size suggests.
std::shared_ptr<rt::StateTable> makeStateTable(const InterfaceInfo& info,
                                               rt::StateTable::Readers readers, unsigned rows = 0);

}  // namespace suture
