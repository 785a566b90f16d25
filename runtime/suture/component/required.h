#pragma once
// A required interface: what a component's code calls, whoever and wherever the provider is.

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
#include <string>
#include <string_view>

namespace suture {

class Channel;

/// The generated members work on these parts of a required interface; users see RequiredBase.
struct RequiredParts {
  RequiredParts(Component& owner, std::string_view name, const InterfaceInfo& info)
      : attachment(owner, name, info) {}

  Attachment attachment;
  CommandSender sender{attachment};
  Reads reads{attachment};
  Calls calls{attachment};
  Subscriptions subscriptions{attachment};
};

/// The part of Required<Contract> that does not depend on the contract. It belongs to the thread of
/// its component; calls from another thread answer Errc::WrongThread.
class RequiredBase : protected RequiredParts {
 public:
  RequiredBase(const RequiredBase&) = delete;
  RequiredBase& operator=(const RequiredBase&) = delete;

  const std::string& name() const { return attachment.name(); }
  const InterfaceInfo& info() const { return attachment.info(); }
  Component& owner() const { return attachment.owner(); }

  /// In the component's constructor: it does without a provider, so no start waits for one.
  /// SUTURE_REQUIRED(optional()) does this for a component that is created by its class.
  void makeOptional() { optional_ = true; }
  bool isOptional() const { return optional_; }

  /// Any thread: it is going to be connected, though that may take a while. A deployment says so of
  /// each of its connections before the components start.
  void expectConnection() { expected_.store(true, std::memory_order_relaxed); }
  /// Any thread: nobody has connected it so far, or is going to. Only then may a component take it
  /// that its system does not have what an optional interface is for.
  bool isAbsent() const { return !expected_.load(std::memory_order_relaxed); }

  /// In the component's constructor: values older than that are stale, unless the connection's own
  /// contract says otherwise. SUTURE_REQUIRED(max_age(t)) does this for a component that is created
  /// by its class.
  void limitAge(Duration maxAge) { maxAge_ = maxAge; }
  Duration maxAge() const { return maxAge_; }

  /// Before it is connected, in the component's constructor for example: the frames in which it
  /// takes poses and vectors. A provider that declares others is refused. Throws SetupError if
  /// others have been declared.
  void declareFrames(const Frames& frames) { frames_.add(frames, name()); }
  const Frames& frames() const { return frames_.get(); }

  /// True if calls can reach the provider now.
  bool connected() { return unusable() == Errc{}; }
  /// Why they cannot; 0 if they can.
  Errc unusable() { return attachment.unusable(); }
  /// The same for one command, which the provider may lack, or which may have to wait for an
  /// operator.
  Errc unusable(std::uint16_t command) { return attachment.unusable(command); }

  /// The owner's thread, after Errc::Invalid: which part of the value it was, "servo_cp.goal.pose".
  /// It is of the last value of this connection that this process refused: arguments that were to
  /// be sent, or a copy of what another process wrote; of a provider in this process its answers,
  /// rows and events as well. It begins with the name of the command or event, and is empty before
  /// the first. Never allocates.
  FieldPath lastInvalid() const;

  /// The events that are subscribed to. Any thread.
  EventSet subscribed() const { return subscriptions.subscribed(); }

  /// Any thread: the connection, or nullptr to take it away. Takes effect at the owner's next
  /// cycle; what it replaces is closed then, and calls under way on it end with
  /// Errc::OutcomeUnknown.
  void attach(std::shared_ptr<Channel> channel);

  /// Owner's thread: takes over what attach() left.
  void adopt() { attachment.adopt(); }
  /// Owner's thread: adopt(), and what the connection's contract says of a loss.
  void lookAtConnection() { attachment.lookAt(); }
  /// The owner's thread, for a device any: lets commands through again that await their operator.
  /// A device does so when it looks at the connection next.
  ResumeOutcome resume() { return attachment.resume(); }
  /// Owner's thread: runs the handlers of the events that have arrived, then those of the calls
  /// that have ended.
  void handleEvents();
  /// Owner's thread: returns when no direct handler of an event is running.
  void awaitDirectHandlers() const { attachment.awaitDirectHandlers(); }
  /// Owner's thread: true if adopt() has something to do.
  bool rewired() const { return attachment.rewired(); }
  /// Owner's thread: true if adopt() or handleEvents() has something to do.
  bool pending() const;
  /// Owner's thread: true if run() has yet to see something that has come since handleEvents():
  /// the answer to a call that nobody has taken, or what was handled in a wait for an event.
  bool unseen();

 protected:
  RequiredBase(Component& owner, std::string_view name, const InterfaceInfo& info);
  ~RequiredBase();

  // --- for those who need no generated members

  /// Like Subscription: `handler` gets the payload's slot of each event `event`, and when it was
  /// emitted; on the `rpc` lane, when it arrived unless it is a replay.
  Result<void> handle(std::uint16_t event, std::function<void(const std::byte*, Time)> handler);
  /// Owner's thread: the connection as it is in this cycle; nullptr if there is none.
  const std::shared_ptr<Channel>& channel() const { return attachment.channel(); }

  /// In a constructor, for the reads alone: looks at the state table of `own`, an interface that
  /// the owner provides itself. Nobody can wire it any more.
  void watch(ProvidedBase& own);

 private:
  bool optional_ = false;
  std::atomic<bool> expected_ = false;
  Duration maxAge_{0};
  DeclaredFrames frames_;
};

/// A component's required interface of type Contract. Each contract's generated header specialises
/// it:
///   Required<Arm> slave_{*this, "Slave"};
///   slave_.servo_cp(goal);
template <class Contract>
class Required {
#ifndef SUTUREC  // suturec reads contracts before their generated headers exist
  static_assert(
      sizeof(Contract) == 0,
      "the contract's generated header is missing: include \"X.suture.h\" beside \"X.h\"");
#endif
 public:
  Required(Component& owner, std::string_view name);
};

}  // namespace suture
