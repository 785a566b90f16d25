#pragma once
// A component is the unit of composition: it has a name, provided and required interfaces, and
// perhaps a thread.

#include <suture/base/time.h>
#include <suture/component/channel/connected_client.h>
#include <suture/component/lifecycle.h>
#include <suture/rt/doorbell.h>
#include <suture/rt/due_bells.h>

#include <atomic>
#include <cstdint>
#include <exception>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace suture {

class Channel;
class ProvidedBase;
class RequiredBase;

/// Says what faulted a component.
enum class FaultCause : std::uint8_t {
  Code,        ///< a hook or handler of the component threw
  Connection,  ///< a connection that was lost or had too old values, whose contract says to fault
};

/// Component is the base of Device and Task. Its interfaces are members of the derived class that
/// register here on construction, so a component neither moves nor copies. lifecycle.h describes
/// its life.
class Component {
 public:
  virtual ~Component();
  Component(const Component&) = delete;
  Component& operator=(const Component&) = delete;

  /// Returns the instance name, which the manager gives: unique in its process.
  const std::string& name() const { return name_; }
  /// Any thread. Returns the state, which may change at any moment.
  ComponentState state() const { return state_.load(std::memory_order_acquire); }
  /// Any thread. Returns what faulted this component last: the text that its code threw, or what
  /// the contract of a connection says; "" if nothing did.
  std::string fault() const;
  /// Any thread. Returns which of the two it was.
  FaultCause faultCause() const;
  /// Any thread. Returns both in words: "its code threw: no answer", "connection '...' is lost,
  /// ...".
  std::string whyFaulted() const;
  /// Any thread. Returns how often it has been faulted.
  std::uint64_t faults() const { return faults_.load(std::memory_order_acquire); }
  /// Returns when it was last resumed or restarted. A command that was sent before is not executed,
  /// however late it arrives, because it was meant for what the component did before.
  Time resumed() const { return fromNanoseconds(resumed_.load(std::memory_order_acquire)); }

  /// Any thread, once the component is constructed. Return its interfaces in the order in which
  /// they are declared.
  const std::vector<ProvidedBase*>& provided() const { return provided_; }
  const std::vector<RequiredBase*>& required() const { return required_; }

  /// Returns true if commands and handlers run in its own thread, and false for a device.
  bool ownsThread() const { return ownsThread_; }
  /// Returns how often a remote client's reads of a device are evaluated. Means nothing for a task.
  virtual Duration remoteReadPeriod() const { return Duration{0}; }

  /// The manager's thread, once, before anything else: calls onConfigure(). Throws SetupError if it
  /// has been called. An exception of the hook is not thrown but parks the component.
  void configure();
  /// Any thread, but not in a hook: asks for Suspend or Resume. A task makes the change between two
  /// cycles, in its own thread; a device at once. Throws SetupError if that is not legal now.
  void request(Transition transition);

  /// A task's thread; for a device, any. Marks the component as failed: its clients get
  /// Errc::Faulted from now on. The first reason stays until the component is restarted.
  void park(std::string reason, FaultCause cause = FaultCause::Code);
  /// Runs `work` of this component. If it throws, this parks the component and returns false.
  template <class Work>
  bool parkOnThrow(const Work& work);
  /// Does the same in the thread of a caller: a task's own thread parks it, before its next cycle.
  template <class Work>
  bool parkSoonOnThrow(const Work& work);

  /// Returns the doorbell at which the owner of this component sleeps.
  rt::Doorbell& doorbell() { return lender_ == nullptr ? doorbell_ : lender_->doorbell(); }
  /// Returns the same doorbell for those who may ring it after this component is gone.
  std::shared_ptr<rt::Doorbell> sharedDoorbell();
  /// The component's own thread. Rings `bell` once, at the end of the cycle; a device rings it at
  /// once.
  void ringLater(rt::Doorbell& bell);
  /// The component's own thread. Rings the client of `channel`, in which an answer or an event has
  /// just been put: at the end of the cycle, unless the client has taken it by then; a device at
  /// once.
  void ringForArrival(Channel& channel);
  /// The component's own thread. Rings what ringLater() collected. Call it before anything that
  /// blocks.
  void ringNow();

  /// Returns true if the calling thread may use this component's required interfaces: the task's
  /// thread, or for a device the first thread that used one.
  bool ownedByThisThread();
  /// Any thread. Returns true if handlers of its events run now, and false if they wait until it is
  /// resumed. It is in one order with awaiting calls that are under way, as endLife() does.
  bool mayRunHandlers() const;
  /// Returns true if another thread owns them. While no thread does, any may use them, as in the
  /// constructor.
  bool ownedByAnotherThread() const;
  /// Returns true for a task that has been started and not been stopped, so that a cycle will come;
  /// for a device there is none.
  bool hasCycles() const;
  /// Any thread. Returns true once a task is asked to stop.
  bool ending() const {
    return ending_.load(std::memory_order_acquire) || (lender_ != nullptr && lender_->ending());
  }
  /// The component's own thread. Returns false once it is asked to stop, but for its hooks: what
  /// they ask of others, such as to hold still, they may await.
  bool mayWait() const { return !ending() || inHook_; }
  /// A task's thread. Returns true if a command of this component ("console:Teleop") is under way
  /// or waits here, so that it does not end while this task waits.
  bool holdsUp(std::string_view component) const;

 protected:
  explicit Component(bool ownsThread);

  // These hooks are called when the component's state changes. If one throws, that parks the
  // component. A task's hooks run in its thread, except onConfigure() (for a CallbackTask, start
  // and stop run in the manager's). A device's hooks run in the thread that asks for the change.

  /// The manager's thread, before the component has one: open devices and allocate here.
  virtual void onConfigure() {}
  /// Runs before the first cycle.
  virtual void onStart() {}
  /// Runs after the last cycle before the suspension: make what moves hold still here.
  virtual void onSuspend() {}
  /// Runs before the cycles go on.
  virtual void onResume() {}
  /// Runs after the last cycle, but not if the component is faulted.
  virtual void onStop() {}
  /// Runs before the cycles of a task go on after a fault: make its members valid again here.
  virtual void onRestart() {}
  /// A task's thread, before the commands of a cycle; for a device the executor's, and only for
  /// clients that do not call it directly. A client of `interface` has connected, and none of its
  /// commands has been executed yet; or its connection has ended, and no more of its commands are
  /// executed. Each is told once while the component runs: an end during a suspension or a fault is
  /// told when the component goes on, and a client that came and went meanwhile is never told.
  virtual void onClient(const ProvidedBase& /*interface*/, const ConnectedClient& /*client*/,
                        ClientNews /*news*/) {}
  /// A task's thread. Returns the client whose command is being executed; null outside of such
  /// handlers.
  const ConnectedClient* caller() const { return caller_; }

  // --- for Device and the kinds of task ---

  /// Any thread. Parks the component, now or soon.
  virtual void parkSoon(std::string reason);
  /// Makes a legal transition to Suspended or Running happen, now or soon.
  virtual void take(Transition transition) = 0;
  /// Makes the legal `transition` here and now: runs the hook, sets the state and tells the
  /// clients.
  void makeTransition(Transition transition);
  /// Stops a component that runs or is suspended, and tells all clients that they have lost it.
  void endLife();

  void setEnding(bool ending) { ending_.store(ending, std::memory_order_release); }

  void claimForThisThread();
  /// Lets the thread of `lender` do this component's work; that thread is then woken for it.
  void borrowThread(Component& lender) { lender_ = &lender; }
  void releaseThread() { owner_.store(nullptr, std::memory_order_release); }

  /// Runs the event handlers of all required interfaces on what has arrived.
  void handleEvents();

 private:
  friend class CommandDrain;
  friend class ProvidedBase;
  friend class RequiredBase;
  friend class Manager;
  friend class Task;

  /// Lets a faulted component run again, unless the hook throws.
  void restart();

  template <class Work, class Failed>
  static bool guarded(const Work& work, const Failed& failed);
  void setStateListener(std::shared_ptr<StateListener> listener);
  void setState(ComponentState state);
  void tellListener(ComponentState state);
  /// Returns false, and changes nothing, if the component has been parked meanwhile.
  bool changeState(ComponentState from, ComponentState to);
  void callHook(Transition transition);
  /// Runs `hook`, in which the component may wait though it is asked to stop.
  template <class Hook>
  void runHook(const Hook& hook);

  const bool ownsThread_;  // read for each event and subscriber
  std::string name_ = "(unnamed)";
  std::weak_ptr<const std::string> process_;  // the manager's name for the process, while it exists
  std::atomic<std::uint64_t> faults_{0};
  std::atomic_flag parked_ = ATOMIC_FLAG_INIT;
  std::atomic<bool> ending_{false};
  std::atomic<ComponentState> state_{ComponentState::Constructed};
  std::atomic<std::int64_t> resumed_{0};  // ns; an atomic Time would compile longer
  std::vector<ProvidedBase*> provided_;
  std::vector<RequiredBase*> required_;
  rt::DueBells dueBells_;
  Component* lender_ = nullptr;
  const ConnectedClient* caller_ = nullptr;
  bool inHook_ = false;
  bool meantToRun_ = false;  // true from a start or the beginning of a resumption, to the beginning
                             // of a suspension or stop; a fault changes nothing
  std::atomic<const void*> owner_{nullptr};
  struct Aside;
  const std::shared_ptr<Aside> aside_;
  rt::Doorbell& doorbell_;
};

template <class Work, class Failed>
bool Component::guarded(const Work& work, const Failed& failed) {
  try {
    work();
    return true;
  } catch (const std::exception& error) {
    failed(error.what());
  } catch (...) {
    failed("an exception that is not a std::exception");
  }
  return false;
}

template <class Hook>
void Component::runHook(const Hook& hook) {
  struct InHook {
    ~InHook() { in = false; }
    bool& in;
  } here{inHook_};
  inHook_ = true;
  hook();
}

template <class Work>
bool Component::parkOnThrow(const Work& work) {
  return guarded(work, [this](std::string reason) { park(std::move(reason)); });
}

template <class Work>
bool Component::parkSoonOnThrow(const Work& work) {
  return guarded(work, [this](std::string reason) { parkSoon(std::move(reason)); });
}

}  // namespace suture
