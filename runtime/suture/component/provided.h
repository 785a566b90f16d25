#pragma once
// A provided interface runs a component's commands, publishes its reads and emits its events.

#ifdef emit
#error \
    "emit is a macro here, as of Qt: define QT_NO_KEYWORDS, and write Q_EMIT, Q_SIGNALS and Q_SLOTS"
#endif

#include <suture/annotate.h>
#include <suture/base/errors.h>
#include <suture/component/channel/channel_list.h>
#include <suture/component/channel/channel_status.h>
#include <suture/component/channel/last_invalid.h>
#include <suture/component/command_clock.h>
#include <suture/component/component.h>
#include <suture/component/contract/declared_frames.h>
#include <suture/component/contract/interface_info.h>
#include <suture/rt/state/row_columns.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace suture::rt {
class StateTable;
struct CommandRecord;
}  // namespace suture::rt

namespace suture {

/// Says how a provided interface keeps the values of its reads.
struct StateOptions {
  /// says how many rows of the past can be read at least; a power of two
  unsigned rows = 64;
  static constexpr unsigned kMostRows = 1u << 20;
  /// lets only advance() publish rows, not the end of each cycle; not for a device
  bool manual = false;
};

/// Holds the part of Provided<Contract> that does not depend on the contract. Commands and reads
/// run in the thread of the component; for a device, in the thread of a local caller or of the
/// executor that serves remote ones.
class ProvidedBase {
 public:
  ProvidedBase(const ProvidedBase&) = delete;
  ProvidedBase& operator=(const ProvidedBase&) = delete;

  /// Any thread. Return the name that the constructor was given, what suturec knows of the
  /// contract, and the component.
  const std::string& name() const { return name_; }
  const InterfaceInfo& info() const { return info_; }
  Component& owner() const { return owner_; }
  /// Any thread. Returns the values of the reads. The first call allocates the table, or throws
  /// SetupError if there is no memory, so an unconnected interface takes neither memory nor a
  /// descriptor.
  const std::shared_ptr<rt::StateTable>& state();
  /// Any thread. Returns the columns of it that clients have asked for.
  rt::ColumnSet demand() const;
  /// Returns the clients. Only the thread that serves this interface may walk along them; any
  /// thread of a device may.
  const ChannelList& channels() const { return channels_; }
  /// Any thread; never allocates. Returns which part of the last row, answer or event the contract
  /// did not admit: "measured_cp.pose". It begins with the name of the command or event, and is
  /// empty while all were valid.
  FieldPath lastInvalid() const { return lastInvalid_.read(); }
  /// Returns the implementation as a pointer to `contract`, which is this interface's or one of its
  /// bases. A local client of a device calls it directly.
  void* implementation(const InterfaceInfo& contract) const;

  /// In the component's constructor. Throws SetupError if the interface is in use already, or if
  /// `options` do not suit it.
  void keepState(const StateOptions& options);

  /// Before any client connects, in the component's constructor for example: declares the frames of
  /// its poses and vectors. A client that expects others is refused. Throws SetupError if others
  /// have been declared.
  void declareFrames(const Frames& frames) { frames_.add(frames, name_); }
  /// Any thread, once clients may connect. Returns what was declared; both are "" if nothing was.
  const Frames& frames() const { return frames_.get(); }

  /// Any thread. Adds a client, which is served from the next cycle on.
  void attach(std::shared_ptr<Channel> channel);
  /// Any thread that may free memory. Lets go of the channels that have ended, if this is a device;
  /// a task does that itself, in its cycles.
  void sweep();

  /// Before any client is connected: makes this interface serve in every state of its component,
  /// also when that is suspended or faulted.
  void serveInEveryState() { everyState_ = true; }
  /// Returns false if commands are refused because the component is suspended or faulted.
  bool inService() const;

  // --- the thread that serves this interface ---

  /// Executes what waits, or refuses it. A handler's exception passes through, after its caller got
  /// Errc::Faulted.
  void drain();
  /// Ends a cycle: calls advance(), unless the component does that itself.
  void publishRow();
  /// Only the thread of a task whose rows are manual. Evaluates the reads that clients asked for
  /// and publishes them as one row, stamped now.
  ///   frames_.keepState({.manual = true});          in the constructor
  ///   if (camera_.newFrame()) frames_.advance();    in run()
  void advance();
  /// Returns true if commands are waiting.
  bool pending() const;
  /// Returns true if commands of this component are waiting: "console:Teleop".
  bool pendingFrom(std::string_view component) const;
  /// In the handler of a queued command: returns how old it was when the clock was last read, which
  /// is up to 64 commands ago in a long drain (docs/howto/reports.md). A suspension of the machine
  /// counts. It means nothing for a command that runs in its caller's thread.
  Duration commandAge() const { return commandAge_; }
  /// Tells all clients in which state the component is.
  void announce(ChannelStatus status);

 protected:
  ProvidedBase(Component& owner, std::string_view name, const InterfaceInfo& info,
               void* implementation);
  virtual ~ProvidedBase();

  /// Runs command `command` on its arguments' slot, and fills `result` if the command has one.
  /// suturec writes it. Returns 0 or Errc::TooLarge.
  virtual Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) = 0;

 private:
  class Execution;

  /// Executes, and answers Errc::Invalid for a result that the contract does not admit. `asker` is
  /// the client that does not get it; null means all clients.
  Errc produce(std::uint16_t command, const std::byte* arguments, std::byte* result,
               Channel* asker);
  void noteInvalid(const FieldPath& path, Channel* asker);
  template <class, class...>
  friend class Emitter;
  friend class EventLoan;
  friend class Subscriptions;

  Errc emit(std::uint16_t event, const std::byte* slot, bool fits);
  /// Returns true in a thread that may not walk the channels and fill the subscribers' queues.
  bool emitsInWrongThread() const;
  /// Returns why no subscriber may get such a payload, or 0.
  Errc judge(std::uint16_t event, const std::byte* slot, bool fits);
  /// Calls `visit(channel, direct)` for each subscriber of `event`; `direct` is true for one whose
  /// handler runs in the thread that emits.
  template <class Visit>
  void forEachSubscriber(std::uint16_t event, const Visit& visit) const;
  /// In a thread that may emit: returns the only subscriber of `event`, if its queue is where the
  /// event goes; else nullptr.
  std::shared_ptr<Channel> onlySubscriber(std::uint16_t event) const;
  /// Emits what EventQueue::lend() of `channel` gave.
  void deliverLent(Channel& channel, std::uint16_t event, std::byte* payload);
  /// Returns true if the component may be told of its clients now.
  bool hears() const;
  static bool isNews(const ChannelList::Node& node);
  void tellOf(ChannelList::Node& node);
  void greet(ChannelList::Node& node);
  void drain(ChannelList::Node& node);
  /// Returns the answer to commands that wait, or 0 if they are executed.
  Errc refusal() const;
  /// Any thread, for a device in this process. Gives `channel`, whose client just subscribed, the
  /// last values.
  void greetLocal(Channel& channel);
  void run(ChannelList::Node& node, const rt::CommandRecord& record);
  void turnAway(Channel& channel, const rt::CommandRecord& record, Errc refusal);
  void tellState(Channel& channel) const;
  void deliver(Channel& channel, std::uint16_t event, Time stamp,
               std::span<const std::byte> payload, bool direct);
  void replay(Channel& channel, EventSet events, std::span<std::uint64_t> memory);
  void replay(Channel& channel, std::uint16_t event, std::span<std::uint64_t> memory);
  void keepLatched(std::uint16_t event, Time stamp, std::span<const std::byte> payload);

  const std::string name_;
  Component& owner_;
  const InterfaceInfo& info_;
  void* implementation_;
  StateOptions options_{.rows = 0};  // 0: as many rows as their size suggests
  std::once_flag stateMade_;
  std::shared_ptr<rt::StateTable> state_;
  std::atomic<rt::StateTable*> made_{nullptr};  // points to what state() has made
  ChannelList channels_;
  DeclaredFrames frames_;
  bool everyState_ = false;
  CommandClock clock_;
  Duration commandAge_{0};
  LastInvalid lastInvalid_;
  struct Latched;
  std::vector<std::unique_ptr<Latched>> latched_;  // by event; null if it is not latched
  std::vector<std::uint64_t> replayed_;            // one payload, for the thread that serves
};

}  // namespace suture
