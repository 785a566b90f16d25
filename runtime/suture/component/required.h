#pragma once
// A required interface: what a component's code calls, whoever and wherever the provider is.

#include <suture/base/errors.h>
#include <suture/base/sample.h>
#include <suture/component/component.h>
#include <suture/component/contract/connection_contract.h>
#include <suture/component/contract/declared_frames.h>
#include <suture/component/contract/interface_info.h>
#include <suture/component/provided.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace suture::rt {
struct EventRecord;
}

namespace suture {

class AwaitedEvent;
class Channel;
struct ReplyRecord;

/// The part of Required<Contract> that does not depend on the contract. It belongs to the thread of
/// its component; calls from another thread answer Errc::WrongThread.
class RequiredBase {
 public:
  /// How large a handler of Call::then() may be.
  static constexpr std::size_t kHandlerSize = 48;

  RequiredBase(const RequiredBase&) = delete;
  RequiredBase& operator=(const RequiredBase&) = delete;

  const std::string& name() const { return name_; }
  const InterfaceInfo& info() const { return info_; }
  Component& owner() const { return owner_; }

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
  void declareFrames(const Frames& frames) { frames_.add(frames, name_); }
  const Frames& frames() const { return frames_.get(); }

  /// True if calls can reach the provider now.
  bool connected() { return unusable() == Errc{}; }
  /// Why they cannot; 0 if they can.
  Errc unusable();
  /// The same for one command, which the provider may lack, or which may have to wait for an
  /// operator.
  Errc unusable(std::uint16_t command);

  /// The owner's thread, after Errc::Invalid: which part of the value it was, "servo_cp.goal.pose".
  /// It is of the last value of this connection that this process refused: arguments that were to
  /// be sent, or a copy of what another process wrote; of a provider in this process its answers,
  /// rows and events as well. It begins with the name of the command or event, and is empty before
  /// the first. Never allocates.
  FieldPath lastInvalid() const;

  /// The events that are subscribed to. Any thread.
  EventSet subscribed() const { return subscribed_.load(std::memory_order_relaxed); }

  /// Any thread: the connection, or nullptr to take it away. Takes effect at the owner's next
  /// cycle; what it replaces is closed then, and calls under way on it end with
  /// Errc::OutcomeUnknown.
  void attach(std::shared_ptr<Channel> channel);

  /// Owner's thread: takes over what attach() left.
  void adopt();
  /// Owner's thread: adopt(), and what the connection's contract says of a loss.
  void lookAtConnection();
  /// The owner's thread, for a device any: lets commands through again that await their operator.
  /// A device does so when it looks at the connection next.
  ResumeOutcome resume();
  /// Owner's thread: runs the handlers of the events that have arrived, then those of the calls
  /// that have ended.
  void handleEvents();
  /// Owner's thread: returns when no direct handler of an event is running.
  void awaitDirectHandlers() const;
  /// Owner's thread: true if adopt() has something to do.
  bool rewired() const { return incoming_.load(std::memory_order_relaxed) != nullptr; }
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
  const std::shared_ptr<Channel>& channel() const { return channel_; }

  /// In a constructor, for the reads alone: looks at the state table of `own`, an interface that
  /// the owner provides itself. Nobody can wire it any more.
  void watch(ProvidedBase& own);

 private:
  friend class CallBase;
  template <class, class>
  friend class Call;
  template <auto, class>
  friend class Command;
  template <auto, class>
  friend class ReadCommand;
  template <class, auto, class, class, class, class...>
  friend class AnsweredCommand;
  template <class, class...>
  friend class Subscription;
  friend class SubscriptionBase;
  friend class AwaitedEvent;
  friend class RowReader;

  using EventHandler = std::function<void(const std::byte*)>;
  struct PendingCall;
  using Follower = void (*)(RequiredBase&, PendingCall&);
  struct PendingCall {
    std::uint32_t number = 0;  // 0: free
    std::uint16_t command = 0;
    bool done = false;
    bool abandoned = false;
    bool fresh = false;  // answered since the last handleEvents()
    Errc error{};
    Time stamp{};
    bool shared = false;  // result holds a counted pointer
    std::span<std::byte> result;
    Follower follower = nullptr;  // null: whoever started it looks at the answer himself
    alignas(std::max_align_t) std::byte handler[kHandlerSize];  // the follower's
  };

  /// The provider if `command` runs in the caller's thread; else nullptr.
  ProvidedBase* callee(std::uint16_t command) const;
  /// Runs `body(Contract&)` on it. A throw parks the provider's component, not the caller.
  template <class Contract, class Body>
  static Errc callHere(ProvidedBase& callee, const Body& body);

  /// Queues a command whose arguments `fill(std::byte*)` stores; it returns false if they do not
  /// fit.
  template <class Fill>
  Errc send(std::uint16_t command, std::uint32_t call, const Fill& fill);
  /// `arguments`: where they go.
  Errc claim(std::uint16_t command, std::uint32_t call, std::byte*& arguments);
  /// Publishes what claim() gave, or gives it up if no provider is to see such arguments.
  Errc commit(std::uint16_t command, const std::byte* arguments, bool fits);
  /// Answers an error, and counts it, if the arguments in a slot did not fit or the contract does
  /// not admit them.
  Errc judge(std::uint16_t command, const std::byte* arguments, bool fits);
  /// Does the same for arguments that go to a handler as they are.
  template <class Slot, class... Arguments>
  Errc judgeHere(std::uint16_t command, Arguments&... arguments);
  /// An error for the result of a call in this thread that no client is to see.
  template <class Slot, class Value>
  Errc judgeResultHere(std::uint16_t command, const Value& value) const;
  /// False, and noted, for a result that the contract does not admit.
  bool admitsResult(std::uint16_t command, const std::byte* result) const;
  /// The same where another process wrote it. It is asked of the copy, which the other process can
  /// no longer change.
  bool admitsCopy(std::uint16_t command, const std::byte* result) const;
  /// Copies the newest result of read `command` into `slot`, unless the provider is a `device`, to
  /// be called directly.
  Sample<void> read(std::uint16_t command, std::byte* slot, bool& device);
  /// The same as it was at `at`; a device has no past.
  Sample<void> readAt(Time at, std::uint16_t command, std::byte* slot, bool& device);
  /// What read() and readAt() do first.
  Errc ask(std::uint16_t command, bool& device);
  /// The reads `commands` of one row, each into its slot: of the newest row, or of that at `at`.
  Sample<void> readRow(const Time* at, std::span<const std::uint16_t> commands,
                       std::span<std::byte* const> slots, bool& device);
  PendingCall* openCall(std::uint16_t command);
  void closeCall(PendingCall& call);
  void collectReplies();
  void noteTaking();
  void collect(ReplyRecord& reply, std::size_t size);
  /// How long within() waits for the answer of `command`.
  Duration deadlineOf(std::uint16_t command) const;
  /// The answer of a read whose newest value is of `stamp`, under the connection's contract.
  Sample<void> judgeAge(Time stamp);
  /// The same where `error` stands in the way: if the provider is lost, as the contract says.
  Sample<void> judgeLoss(Errc error, std::uint16_t command, std::byte* slot);
  /// True if the connection's contract says what a read answers that meets `error`.
  bool ruledByContract(Errc error) const;
  Sample<void> fallBack(Fallback fallback, Errc error, Time stamp);
  /// True if `answer` stands for a value that is zero by contract.
  bool zeroes(const Sample<void>& answer) const;
  /// What has been lost so far: equal if nothing has been since.
  std::pair<const void*, std::uint64_t> losses() const;
  /// Acts on each loss of the provider, once.
  void noticeLoss();
  bool awaitsOperator(std::uint16_t command) const;
  void close(const std::shared_ptr<Channel>& channel);
  /// Frees the place of a call that is over.
  void discard(PendingCall& call);
  bool isDone(PendingCall& call);
  void waitFor(PendingCall& call, Duration limit);
  /// True if the provider will not execute it, and answers so.
  bool cancel(PendingCall& call);
  /// `follower` is called in the owner's thread as soon as `call` is done.
  void follow(PendingCall& call, Follower follower);
  /// What ends the calls under way; 0: nothing.
  Errc endOfCalls() const;
  bool followedMayBeDone() const;
  void finishFollowed();
  /// Leaves what has come by now to run().
  void offerNews();
  /// Errc::WrongThread if the interface is another thread's.
  Errc subscribe(std::uint16_t event, EventHandler handler, bool direct = false);
  Errc unsubscribe(std::uint16_t event);
  /// Tells the provider's end what is subscribed to by now.
  void passSubscriptionsOn(EventSet joining);
  /// Has the provider run the handler of `event` itself, if that is direct and both are here.
  void lendHandler(std::uint16_t event);
  /// Returns how many events it has handled.
  std::size_t handleQueuedEvents();
  void deliver(const rt::EventRecord& record);

  Errc arm(AwaitedEvent& event);
  bool isAwaited(std::uint16_t event) const;
  template <class Whether>
  void endAwaited(Errc error, const Whether& whether);
  void loseAwaited();
  void refuseAwaited(std::uint16_t event);
  void satisfyAwaited(const rt::EventRecord& record);
  /// Why no event will come any more; 0: one may.
  Errc endOfEvents() const;
  std::size_t handleArrivals();

  const std::string name_;
  Component& owner_;
  const InterfaceInfo& info_;
  std::shared_ptr<Channel> channel_;
  std::atomic<std::shared_ptr<Channel>*> incoming_{nullptr};
  struct Tables;                          // of its calls and events
  const std::shared_ptr<Tables> tables_;  // nobody else's; a unique_ptr compiles longer
  std::uint32_t callsOpened_ = 0;
  unsigned fresh_ = 0;                   // calls that are
  bool handledInWait_ = false;           // events, other than the one waited for
  unsigned followed_ = 0;                // calls that have a follower
  std::atomic<EventSet> subscribed_{0};  // the owner's; read by who connects
  AwaitedEvent* awaited_ = nullptr;      // the first
  bool handling_ = false;                // a handler of an event is running
  bool optional_ = false;
  std::atomic<bool> expected_ = false;
  Duration maxAge_{0};
  DeclaredFrames frames_;
  // True once noticeLoss() has dealt with the loss of channel_.
  bool lossNoticed_ = false;
  std::atomic<bool> resumeAsked_{false};  // of a device
  std::uint32_t faultsNoticed_ = 0;
};

template <class Contract, class Body>
Errc RequiredBase::callHere(ProvidedBase& callee, const Body& body) {
  const bool returned = callee.owner().parkSoonOnThrow([&] {
    const InterfaceInfo& contract = interfaceInfo<std::remove_const_t<Contract>>();
    body(*static_cast<Contract*>(callee.implementation(contract)));
  });
  return returned ? Errc{} : Errc::Faulted;
}

template <class Fill>
Errc RequiredBase::send(std::uint16_t command, std::uint32_t call, const Fill& fill) {
  std::byte* arguments = nullptr;
  const Errc error = claim(command, call, arguments);
  return error == Errc{} ? commit(command, arguments, fill(arguments)) : error;
}

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
