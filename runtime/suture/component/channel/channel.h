#pragma once
// Everything between one client endpoint and one provider endpoint within a process. The local lane
// is one channel shared by two tasks; every other lane carries what it finds in one channel to
// another.

#include <suture/base/arena.h>
#include <suture/base/slots/shared_slot.h>
#include <suture/component/channel/channel_counts.h>
#include <suture/component/channel/delivery_counters.h>
#include <suture/component/channel/direct_handlers.h>
#include <suture/component/channel/last_invalid.h>
#include <suture/component/channel/lease.h>
#include <suture/component/channel/peer_state.h>
#include <suture/component/contract/connection_contract.h>
#include <suture/component/contract/interface_info.h>
#include <suture/rt/doorbell.h>
#include <suture/rt/histogram.h>
#include <suture/rt/queue/event_queue.h>
#include <suture/rt/queue/mailbox.h>
#include <suture/rt/queue/spsc_ring.h>
#include <suture/rt/shared_flag.h>
#include <suture/rt/state/state_table.h>
#include <suture/standard/lifecycle.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace suture {

class Ledger;
class ProvidedBase;

enum class ChannelStatus : std::uint8_t {
  Connected,
  Lost,       ///< the far end went away
  Faulted,    ///< the provider's handler threw
  Closed,     ///< this connection was taken down; both ends let go of it
  Suspended,  ///< the provider executes nothing until it is resumed, or started again
  Lapsed,     ///< provider endpoint: its client has not been heard of for as long as it waits
};

/// Precedes the result of every answered call.
struct ReplyRecord {
  Time stamp;             ///< when the result was produced, on this process's clock
  std::uint32_t call;     ///< the number of the call
  Errc error;             ///< 0: success, and the result follows
  bool shared;            ///< the result is a counted pointer, see base/slots/shared_slot.h
  std::uint16_t command;  ///< whose result it is, unless there is an error

  std::byte* result() { return reinterpret_cast<std::byte*>(this + 1); }
  const std::byte* result() const { return reinterpret_cast<const std::byte*>(this + 1); }
};

/// What the result of a call is in its record.
struct ResultForm {
  std::uint32_t size = 0;
  bool shared = false;
  std::uint16_t command = 0;
};

/// Each endpoint is one thread, and neither waits for the other. The client endpoint produces into
/// `commands` and consumes `replies`, `events` and `state`; the provider endpoint is the other side
/// of each.
class Channel {
 public:
  /// How many calls with an answer may be unfinished at a time.
  static constexpr unsigned kMaxCalls = 16;

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
  /// object of its own, and uses it as one of the two endpoints.
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
  std::string_view client() const {
    return std::string_view(name()).substr(0, name().rfind(" -> "));
  }
  const std::string lane;
  const Ends ends;
  const std::shared_ptr<rt::StateTable> state;
  /// The other end is another process, which may write anything at any time: copy what comes from
  /// it, and believe nothing in the copy.
  const bool foreign;

 private:
  /// What the ends tell each other beside the queues; first in the memory.
  struct Words {
    std::atomic<EventSet> subscribed{0}, joining{0};
    std::array<std::atomic<std::uint32_t>, kMaxCalls> claims{};  // 0 is no call's number
    rt::SharedFlag wantsRows, untaken, cut;
  };
  const std::shared_ptr<Words> words_;

 public:
  rt::Mailbox commands;
  rt::SpscRing replies;
  rt::EventQueue events;
  const std::shared_ptr<ChannelCounts> counts;
  DirectHandlers direct;  ///< used where both ends share a process and no delay lies between
  std::atomic<ChannelStatus> status{ChannelStatus::Connected};
  /// How often the status has become Faulted: a provider may be restarted before anybody looks.
  std::atomic<std::uint32_t> faults{0};
  /// Set by a client endpoint that must be rung for a row, credits or a tally as well: the far side
  /// of a lane.
  rt::SharedFlag& wantsRows;

  /// Age of the values read, when they were read: of each row when it is first read, and of every
  /// 16th read of a row that has been read before. nullptr if the client is no component here.
  const std::unique_ptr<rt::Histogram> readAge;
  /// Age of each command, when it was executed. nullptr if the provider is no component here.
  const std::unique_ptr<rt::Histogram> commandAge;
  std::atomic<std::uint64_t> bytesSent{0}, bytesReceived{0};  ///< on the lane's wire; 0 on `local`
  DeliveryCounters delivery;  ///< client's end, both ways; all 0 on a lane that loses nothing
  LastInvalid lastInvalid;    ///< of what this process judged, at either end

  /// Any thread: false for arguments, a result or a payload that the contract does not admit; then
  /// notes which part of it that is.
  bool admits(const CommandInfo& command, const std::byte* arguments);
  bool admitsResult(const CommandInfo& command, const std::byte* result);
  /// The same of a copy, which the provider can no longer change.
  bool admitsCopy(const CommandInfo& command, const std::byte* result);
  bool admits(const EventInfo& event, const std::byte* payload);

  /// Counts what this endpoint has put into foreign memory, or taken out of it, with what the
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

  /// Client endpoint: wants `wanted` from now on, first the last values of the latched ones among
  /// `newlyWanted`. The caller rings the provider. Commands that are sent later meet it done.
  void subscribe(EventSet wanted, EventSet newlyWanted);
  EventSet subscribed() const { return words_->subscribed.load(std::memory_order_acquire); }
  /// Provider endpoint, before subscribed(): the events whose last value the client is to get now.
  EventSet takeJoining();
  /// True if takeJoining() has something to give.
  bool joining() const { return words_->joining.load(std::memory_order_relaxed) != 0; }

  /// Any thread: sets how it stands with the provider, unless the connection is past that, and
  /// rings the client if that is news.
  void tell(ChannelStatus news);
  /// Client endpoint, any thread: lets commands through again that await their operator, if the
  /// provider is there.
  ResumeOutcome resume();
  /// Notes a status that was changed without tell(), for the trace of a stepped clock.
  void noteStatus(ChannelStatus news) const;

  /// Provider endpoint: how long its client's commands may be executed.
  const Lease lease;
  /// Client endpoint, any thread, before the client is told that the connection is over: where both
  /// share memory, the provider begins nothing more of it.
  void cut() { words_->cut.raise(); }
  /// Provider endpoint, just before it executes a command: an error if the connection is over.
  /// `looksAtClock`: also if its lease has ended, which ends it.
  Errc begin(bool looksAtClock);

  /// Either endpoint claims a call: the client in order to cancel it, the provider to execute it.
  /// True for the one that claims it first.
  bool claimCall(std::uint32_t call) {
    return words_->claims[call % kMaxCalls].exchange(call, std::memory_order_acq_rel) != call;
  }

  /// Provider endpoint: answers call `call` with an error.
  void replyError(std::uint32_t call, Errc error);
  /// Provider endpoint: answers call `call`; `produce(std::byte* result)` fills the result in place
  /// and returns an Errc, 0 for success. `stamp`: when the result was produced.
  template <class Produce>
  void reply(std::uint32_t call, ResultForm form, const Produce& produce, Time stamp = now());

  /// Up if a reply or an event has been put in since the client end last looked. Whoever lowers it
  /// looks into both before it sleeps.
  rt::SharedFlag& untaken;
  /// Client endpoint, before it looks.
  void lowerUntaken() {
    if (untaken.isUp(std::memory_order_relaxed)) untaken.take(std::memory_order_acq_rel);
  }

  /// Client endpoint: nextReply() is the oldest answer, or nullptr. popReply() lets go of it, and
  /// of its result unless that has been moved elsewhere and is null now.
  ReplyRecord* nextReply();
  void popReply();

 private:
  static ReplyRecord* makePossible(std::byte* memory);
  void count(std::atomic<std::uint64_t>& counter, std::size_t bytes) const {
    if (foreign) counter.fetch_add(bytes, std::memory_order_relaxed);
  }
};

template <class Produce>
void Channel::reply(std::uint32_t call, ResultForm form, const Produce& produce, Time stamp) {
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
  countSent(rt::SpscRing::recordSize(sizeof(ReplyRecord) + form.size));
}

/// True if nothing comes through any more.
bool isOver(ChannelStatus status);

/// The error that a call through a channel of this status meets; 0 if it is connected.
Errc errorOf(ChannelStatus status);

/// The error that ends a call under way without an answer; 0 if one may still come: a suspended
/// provider answers what it was sent.
Errc endOfCalls(ChannelStatus status);

/// The status of a connection to a component in this state; Connected also before its first cycle.
ChannelStatus statusIn(ComponentState state);

/// A contract's state table: one column a read. `readers`: whether another process may map it.
/// `rows`: at least so many; 0: as many as their size suggests.
std::shared_ptr<rt::StateTable> makeStateTable(const InterfaceInfo& info,
                                               rt::StateTable::Readers readers, unsigned rows = 0);

}  // namespace suture
