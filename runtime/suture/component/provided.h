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
#include <suture/component/component.h>
#include <suture/component/contract/declared_frames.h>
#include <suture/component/contract/interface_info.h>
#include <suture/component/provided/command_drain.h>
#include <suture/component/provided/command_runner.h>
#include <suture/component/provided/event_emission.h>
#include <suture/component/provided/interface_clients.h>
#include <suture/component/provided/row_publisher.h>

#include <memory>
#include <string>
#include <string_view>

namespace suture {

/// Holds the part of Provided<Contract> that does not depend on the contract. Commands and reads
/// run in the thread of the component; for a device, in the thread of a local caller or of the
/// executor that serves remote ones.
class ProvidedBase : private CommandRunner {
 public:
  ProvidedBase(const ProvidedBase&) = delete;
  ProvidedBase& operator=(const ProvidedBase&) = delete;

  /// Any thread. Return the name that the constructor was given, what suturec knows of the
  /// contract, and the component.
  const std::string& name() const { return clients_.name(); }
  const InterfaceInfo& info() const { return clients_.info(); }
  Component& owner() const { return clients_.owner(); }
  /// Any thread. Returns the values of the reads. The first call allocates the table, or throws
  /// SetupError if there is no memory, so an unconnected interface takes neither memory nor a
  /// descriptor.
  const std::shared_ptr<rt::StateTable>& state() { return rows_.table(); }
  /// Any thread. Returns the columns of it that clients have asked for.
  rt::ColumnSet demand() const { return rows_.demand(); }
  /// Returns the clients. Only the thread that serves this interface may walk along them; any
  /// thread of a device may.
  const ChannelList& channels() const { return clients_.channels(); }
  /// Any thread; never allocates. Returns which part of the last row, answer or event the contract
  /// did not admit: "measured_cp.pose". It begins with the name of the command or event, and is
  /// empty while all were valid.
  FieldPath lastInvalid() const { return clients_.lastInvalid(); }
  /// Returns the implementation as a pointer to `contract`, which is this interface's or one of its
  /// bases. A local client of a device calls it directly.
  void* implementation(const InterfaceInfo& contract) const;

  /// In the component's constructor. Throws SetupError if the interface is in use already, or if
  /// `options` do not suit it.
  void keepState(const StateOptions& options) { rows_.keep(options); }

  /// Before any client connects, in the component's constructor for example: declares the frames of
  /// its poses and vectors. A client that expects others is refused. Throws SetupError if others
  /// have been declared.
  void declareFrames(const Frames& frames) { frames_.add(frames, name()); }
  /// Any thread, once clients may connect. Returns what was declared; both are "" if nothing was.
  const Frames& frames() const { return frames_.get(); }

  /// Any thread. Adds a client, which is served from the next cycle on.
  void attach(std::shared_ptr<Channel> channel);
  /// Any thread that may free memory. Lets go of the channels that have ended, if this is a device;
  /// a task does that itself, in its cycles.
  void sweep() { clients_.sweep(); }

  /// Before any client is connected: makes this interface serve in every state of its component,
  /// also when that is suspended or faulted.
  void serveInEveryState() { clients_.serveInEveryState(); }
  /// Returns false if commands are refused because the component is suspended or faulted.
  bool inService() const { return clients_.inService(); }

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
  void advance() { rows_.publish(); }
  /// Returns true if commands, subscribers or news of clients are waiting.
  bool pending() const { return clients_.pending(); }
  /// Returns true if commands of this component are waiting: "console:Teleop".
  bool pendingFrom(std::string_view component) const { return clients_.pendingFrom(component); }
  /// In the handler of a queued command: returns how old it was when the clock was last read, which
  /// is up to 64 commands ago in a long drain (docs/howto/reports.md). A suspension of the machine
  /// counts. It means nothing for a command that runs in its caller's thread.
  Duration commandAge() const { return commands_.commandAge(); }
  /// Tells all clients in which state the component is.
  void announce(ChannelStatus status) { clients_.announce(status); }

 protected:
  ProvidedBase(Component& owner, std::string_view name, const InterfaceInfo& info,
               void* implementation);
  virtual ~ProvidedBase();

 private:
  template <class, class...>
  friend class Emitter;
  friend class Subscriptions;

  void* const implementation_;
  InterfaceClients clients_;
  EventEmission emission_{clients_};
  RowPublisher rows_{clients_, *this};
  CommandDrain commands_{clients_, *this};
  DeclaredFrames frames_;
};

}  // namespace suture
