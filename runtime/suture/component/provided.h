#pragma once
// A provided interface: what runs a component's commands, publishes its reads and emits its events.

#include <suture/base/errors.h>
#include <suture/component/channel/channel_list.h>
#include <suture/component/channel/channel_status.h>
#include <suture/component/channel/last_invalid.h>
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

/// How a provided interface keeps the values of its reads.
struct StateOptions {
  /// How many rows of the past can be read: at least so many, a power of two.
  unsigned rows = 64;
  /// Rows are published by advance() alone, not at the end of each cycle. Not for a device.
  bool manual = false;
};

/// The part of Provided<Contract> that does not depend on the contract. Commands and reads run in
/// the thread of the component; for a device, in the thread of a local caller or of the executor
/// that serves remote ones.
class ProvidedBase {
 public:
  ProvidedBase(const ProvidedBase&) = delete;
  ProvidedBase& operator=(const ProvidedBase&) = delete;

  const std::string& name() const { return name_; }
  const InterfaceInfo& info() const { return info_; }
  Component& owner() const { return owner_; }
  /// Any thread: the values of the reads. The first call makes room for them and throws SetupError
  /// if there is none: an interface that nobody is connected to takes no memory and no descriptor.
  const std::shared_ptr<rt::StateTable>& state();
  /// Any thread: the columns of it that somebody has asked for.
  rt::ColumnSet demand() const;
  const ChannelList& channels() const { return channels_; }
  /// Any thread: which part was wrong of the last row, answer or event that this interface produced
  /// and that its contract does not admit: "measured_cp.pose". It begins with the name of the
  /// command or event, and is empty before the first. Never allocates.
  FieldPath lastInvalid() const { return lastInvalid_.read(); }
  /// The implementation, as a pointer to `contract`, which is this one's or one of its bases: what
  /// a local client of a device calls directly.
  void* implementation(const InterfaceInfo& contract) const;

  /// In the component's constructor. Throws SetupError if the interface is in use already, or
  /// cannot be so.
  void keepState(const StateOptions& options);

  /// Before anybody connects, in the component's constructor for example: the frames that its poses
  /// and vectors are in. A client that expects others is refused. Throws SetupError if others have
  /// been declared.
  void declareFrames(const Frames& frames) { frames_.add(frames, name_); }
  const Frames& frames() const { return frames_.get(); }

  /// Any thread: one more client. It is served from the next cycle on.
  void attach(std::shared_ptr<Channel> channel);

  /// Before anybody is connected: this interface is served in every state of its component, also
  /// when it is suspended or faulted.
  void serveInEveryState() { everyState_ = true; }
  /// False if what arrives is turned away, since the component is suspended or faulted.
  bool inService() const;

  // --- the thread that serves this interface ---

  /// Executes what is waiting, or turns it away. A handler's exception passes through, after its
  /// caller got Errc::Faulted.
  void drain();
  /// The end of a cycle: advance(), unless that is the component's own business.
  void publishRow();
  /// Evaluates the reads that somebody asked for and publishes them as one row, stamped now. For a
  /// task whose rows are manual; its thread only.
  ///   frames_.keepState({.manual = true});          in the constructor
  ///   if (camera_.newFrame()) frames_.advance();    in run()
  void advance();
  /// True if commands are waiting.
  bool pending() const;
  /// In the handler of a command that has waited: how old that was when it was compared with its
  /// ttl. Says nothing of one that runs in its caller's thread.
  Duration commandAge() const { return commandAge_; }
  /// Tells all clients how it stands with the component.
  void announce(ChannelStatus status);

 protected:
  ProvidedBase(Component& owner, std::string_view name, const InterfaceInfo& info,
               void* implementation);
  virtual ~ProvidedBase();

  /// Runs command `command` on its arguments' slot; fills `result` if the command has one. Written
  /// by suturec. Returns 0 or Errc::TooLarge.
  virtual Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) = 0;

 private:
  class Turn;

  /// Executes, and answers Errc::Invalid for a result that the contract does not admit. `asker` is
  /// who misses it; null: all clients.
  Errc produce(std::uint16_t command, const std::byte* arguments, std::byte* result,
               Channel* asker);
  void noteInvalid(const FieldPath& path, Channel* asker);
  template <class, class...>
  friend class Emitter;
  friend class Subscriptions;

  Errc emit(std::uint16_t event, const std::byte* slot, bool fits);
  /// True if the component may be told of its clients now.
  bool hears() const;
  static bool isNews(const ChannelList::Node& node);
  void tellOf(ChannelList::Node& node);
  void greet(ChannelList::Node& node);
  void drain(ChannelList::Node& node);
  /// What commands that wait are answered now; 0: they are executed.
  Errc refusal() const;
  /// Any thread, of a device in this process: gives `channel`, whose client just subscribed, the
  /// last values.
  void greetLocal(Channel& channel);
  void run(ChannelList::Node& node, const rt::CommandRecord& record, Time present);
  void turnAway(Channel& channel, const rt::CommandRecord& record, Errc refusal);
  void tellState(Channel& channel) const;
  void deliver(Channel& channel, std::uint16_t event, Time stamp,
               std::span<const std::byte> payload, EventSet direct);
  void replay(Channel& channel, EventSet events, std::span<std::uint64_t> memory);
  void replay(Channel& channel, std::uint16_t event, std::span<std::uint64_t> memory);
  void keepLatched(std::uint16_t event, Time stamp, std::span<const std::byte> payload);

  const std::string name_;
  Component& owner_;
  const InterfaceInfo& info_;
  void* implementation_;
  StateOptions options_{.rows = 0};  // 0 rows: as many as their size suggests
  std::once_flag stateMade_;
  std::shared_ptr<rt::StateTable> state_;
  std::atomic<rt::StateTable*> made_{nullptr};  // what state() has made
  ChannelList channels_;
  DeclaredFrames frames_;
  bool everyState_ = false;
  Duration commandAge_{0};
  LastInvalid lastInvalid_;
  struct Latched;
  std::vector<std::unique_ptr<Latched>> latched_;  // by event; null: it is not latched
  std::vector<std::uint64_t> replayed_;            // one payload, for the thread that serves
};

/// A component's provided interface of type Contract. Each contract's generated header specialises
/// it:
///   Provided<Arm> arm_{*this, "Arm", *this};
///   arm_.emit().operating_state(value);
template <class Contract>
class Provided {
#ifndef SUTUREC  // suturec reads contracts before their generated headers exist
  static_assert(
      sizeof(Contract) == 0,
      "the contract's generated header is missing: include \"X.suture.h\" beside \"X.h\"");
#endif
 public:
  Provided(Component& owner, std::string_view name, Contract& implementation);
};

}  // namespace suture
