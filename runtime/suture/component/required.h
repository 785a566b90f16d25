#pragma once
// A component's code calls a required interface, whatever provides it and wherever that runs.

#include <suture/annotate.h>
#include <suture/base/errors.h>
#include <suture/component/component.h>
#include <suture/component/contract/declared_frames.h>
#include <suture/component/contract/interface_info.h>
#include <suture/component/required/attachment.h>
#include <suture/component/required/calls.h>
#include <suture/component/required/command_sender.h>
#include <suture/component/required/reads.h>
#include <suture/component/required/subscriptions.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace suture {

class Channel;

/// Holds the parts of a required interface that the generated members use; users see RequiredBase.
struct RequiredParts {
  RequiredParts(Component& owner, std::string_view name, const InterfaceInfo& info)
      : attachment(owner, name, info) {}

  Attachment attachment;
  CommandSender sender{attachment};
  Reads reads{attachment};
  Calls calls{attachment};
  Subscriptions subscriptions{attachment};
};

/// Belongs to the thread of its component; calls from another thread answer Errc::WrongThread. It
/// has the part of Required<Contract> that does not depend on the contract.
class RequiredBase : protected RequiredParts {
 public:
  RequiredBase(const RequiredBase&) = delete;
  RequiredBase& operator=(const RequiredBase&) = delete;

  /// Any thread. Return the name that the constructor was given, what suturec knows of the
  /// contract, and the component.
  const std::string& name() const { return attachment.name(); }
  const InterfaceInfo& info() const { return attachment.info(); }
  Component& owner() const { return attachment.owner(); }

  /// In the component's constructor: lets it do without a provider, so no start waits for one.
  /// SUTURE_REQUIRED(optional()) does this for a component that is created by its class.
  void makeOptional() { optional_ = true; }
  bool isOptional() const { return optional_; }

  /// Any thread. Says that it will be connected, perhaps after a while. A deployment says so of
  /// each of its connections before the components start.
  void expectConnection() { expected_.store(true, std::memory_order_relaxed); }
  /// Any thread. Returns true if it is not connected and will not be. Only then may a component
  /// conclude that its system lacks what an optional interface is for.
  bool isAbsent() const { return !expected_.load(std::memory_order_relaxed); }

  /// In the component's constructor: makes values older than that stale, unless the connection's
  /// own contract says otherwise. SUTURE_REQUIRED(max_age(t)) does this for a component that is
  /// created by its class.
  void limitAge(Duration maxAge) { maxAge_ = maxAge; }
  Duration maxAge() const { return maxAge_; }

  /// Returns true if it has said needRows().
  bool needsRows() const { return needsRows_; }

  /// Before it is connected, in the component's constructor for example: declares the frames in
  /// which it takes poses and vectors. A provider that declares others is refused. Throws
  /// SetupError if others have been declared.
  void declareFrames(const Frames& frames) { frames_.add(frames, name()); }
  const Frames& frames() const { return frames_.get(); }

  /// Returns true if calls can reach the provider now.
  bool connected() { return unusable() == Errc{}; }
  /// Returns why they cannot, or 0 if they can.
  Errc unusable() { return attachment.unusable(); }
  /// Returns the same for one command, which the provider may lack, or which may have to wait for
  /// an operator.
  Errc unusable(std::uint16_t command) { return attachment.unusable(command); }

  /// Owner's thread, after Errc::Invalid; never allocates. Returns which part of a value was
  /// invalid, beginning with the name of the command or event: "servo_cp.goal.pose". The value is
  /// the last one of this connection that this process refused; the path is empty if it has refused
  /// none. A process refuses arguments that it was to send, and copies of what another process
  /// wrote; if the provider is in this process, also its answers, rows and events.
  FieldPath lastInvalid() const;

  /// Any thread. Returns the events that are subscribed to.
  EventSet subscribed() const { return subscriptions.subscribed(); }

  /// Any thread. Sets the connection, or takes it away if null. It takes effect at the owner's next
  /// cycle; then the connection that it replaces is closed, and calls under way on that end with
  /// Errc::OutcomeUnknown.
  void attach(std::shared_ptr<Channel> channel);

  /// Any thread but a task's. Returns what attach() was given last; nullptr if it is gone.
  std::shared_ptr<Channel> attached() const;

  /// Owner's thread. Takes over the channel that attach() left.
  void adopt() { attachment.adopt(); }
  /// Owner's thread. Calls adopt(), and does what the connection's contract says of a loss.
  void updateConnection() { attachment.update(); }
  /// Owner's thread. Returns true while the provider is lost and the contract faults this component
  /// for that.
  bool lossFaults() const { return attachment.lossFaults(); }
  /// Owner's thread; for a device, any thread. Admits commands again on a connection that awaits
  /// its operator. A device admits them when it next looks at the connection.
  ResumeOutcome resume() { return attachment.resume(); }
  /// Owner's thread. Runs the handlers of the events that have arrived, then those of the calls
  /// that have ended.
  void handleEvents();
  /// Owner's thread. Returns when no direct handler of an event is running.
  void awaitDirectHandlers() const { attachment.awaitDirectHandlers(); }
  /// Owner's thread. Returns true if adopt() has something to do.
  bool rewired() const { return attachment.rewired(); }
  /// Owner's thread. Returns true if adopt() or handleEvents() has something to do.
  bool pending() const;
  /// Owner's thread. Returns true in a handler of one of its events.
  bool handling() const { return subscriptions.handling(); }
  /// Owner's thread. Returns true if something has come since handleEvents() that run() has not
  /// seen: an answer that it has not taken, what was handled in a wait for an event, or what is
  /// pending(). Nobody rings for what came before, so ask this last before a sleep.
  bool unseen();

 protected:
  RequiredBase(Component& owner, std::string_view name, const InterfaceInfo& info);
  ~RequiredBase();

  // --- for those who need no generated members

  /// Subscribes like Subscription: `handler` gets the payload's slot of each event `event`, and
  /// when it was emitted, on the clock of this process.
  Result<void> handle(std::uint16_t event, std::function<void(const std::byte*, Time)> handler);
  /// In a constructor: says that it needs the rows of its provider's state table one by one, so it
  /// cannot be connected to a device of its own process, whose reads are evaluated by each call.
  void needRows() { needsRows_ = true; }

  /// Owner's thread. Returns the connection as it is in this cycle; nullptr if there is none.
  const std::shared_ptr<Channel>& channel() const { return attachment.channel(); }

  /// In a constructor, for the reads alone: looks at the state table of `own`, an interface that
  /// the owner provides itself. It cannot be connected after that.
  void watch(ProvidedBase& own);

 private:
  bool optional_ = false;
  bool needsRows_ = false;
  std::atomic<bool> expected_ = false;
  Duration maxAge_{0};
  DeclaredFrames frames_;
  mutable std::mutex attachedMutex_;  // never taken by a task's thread
  std::weak_ptr<Channel> attached_;
};

}  // namespace suture
