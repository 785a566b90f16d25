#pragma once
// The unit of composition: something with a name, provided and required interfaces, and perhaps a
// thread.

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

/// What faulted a component.
enum class FaultCause : std::uint8_t {
  Code,        ///< its own: a hook or handler threw
  Connection,  ///< a connection whose contract says so: lost, or its values too old
};

/// Base of Device and Task. Its interfaces are members of the derived class that register here on
/// construction; so a component neither moves nor copies. Its life: lifecycle.h.
class Component {
 public:
  virtual ~Component();
  Component(const Component&) = delete;
  Component& operator=(const Component&) = delete;

  /// The instance name, given by the manager: unique in its process.
  const std::string& name() const { return name_; }
  ComponentState state() const { return state_.load(std::memory_order_acquire); }
  /// What faulted this component last: the text that its code threw, or what the contract of a
  /// connection says; "" if nothing did. Any thread.
  std::string fault() const;
  /// Which of the two. Any thread.
  FaultCause faultCause() const;
  /// Both in words: "its code threw: no answer", "connection '...' is lost, ...". Any thread.
  std::string whyFaulted() const;
  /// How often it has been faulted. Any thread.
  std::uint64_t faults() const { return faults_.load(std::memory_order_acquire); }
  /// When it was last resumed or restarted. A command sent before is not executed, however late it
  /// arrives: it was meant for what the component did before.
  Time resumed() const { return fromNanoseconds(resumed_.load(std::memory_order_acquire)); }

  const std::vector<ProvidedBase*>& provided() const { return provided_; }
  const std::vector<RequiredBase*>& required() const { return required_; }

  /// True if commands and handlers run in a thread of its own; false for a device.
  bool ownsThread() const { return ownsThread_; }
  /// How often a remote client's reads of a device are evaluated. Meaningless for a task.
  virtual Duration remoteReadPeriod() const { return Duration{0}; }

  /// The manager's thread, once, before anything else: calls onConfigure(). Throws SetupError if it
  /// has been done. What the hook throws parks the component instead.
  void configure();
  /// Any thread but in a hook: asks for Suspend or Resume. A task makes the change between two
  /// cycles, in its own thread; a device at once. Throws SetupError if that is not legal now.
  void request(Transition transition);

  /// A task's thread; of a device, any: the component has failed; its clients are told
  /// Errc::Faulted from now on. The first reason stays, until the component is restarted.
  void park(std::string reason, FaultCause cause = FaultCause::Code);
  /// Runs `work` of this component; what it throws parks the component. False if it did.
  template <class Work>
  bool parkOnThrow(const Work& work);
  /// The same in the thread of a caller: a task is parked by its own thread, before its next cycle.
  template <class Work>
  bool parkSoonOnThrow(const Work& work);

  /// What a sleeping owner of this component waits on.
  rt::Doorbell& doorbell() { return lender_ == nullptr ? doorbell_ : lender_->doorbell(); }
  /// The same, for those who may ring it when this component is gone.
  std::shared_ptr<rt::Doorbell> sharedDoorbell();
  /// From the component's own thread: rings `bell` once at the end of the cycle; from a device, at
  /// once.
  void ringLater(rt::Doorbell& bell);
  /// The same for the client of `channel`, in which an answer or an event has just been put. Not
  /// rung if it has been taken by then.
  void ringForArrival(Channel& channel);
  /// From the component's own thread: rings what ringLater() collected. Called before anything that
  /// blocks.
  void ringNow();

  /// True if the calling thread may use this component's required interfaces: the task's thread;
  /// for a device, the first thread that used one.
  bool ownedByThisThread();
  /// Any thread: true if handlers of its events run now, instead of waiting until it is resumed. It
  /// is in one order with awaiting calls that are under way, as endLife() does.
  bool mayRunHandlers() const;
  /// True if another thread owns them. While none does, any may use them, as in the constructor.
  bool ownedByAnotherThread() const;
  /// Any thread: true once a task is asked to stop. It begins nothing any more that waits.
  bool ending() const {
    return ending_.load(std::memory_order_acquire) || (lender_ != nullptr && lender_->ending());
  }

 protected:
  explicit Component(bool ownsThread);

  // What a component does when its state changes. A hook that throws parks its component. A task's
  // run in its thread (those of a callback's task to start and stop in the manager's), but
  // onConfigure(); a device's in the thread that asks for the change.

  /// Before there is a thread: the place to open devices and to allocate. The manager's thread.
  virtual void onConfigure() {}
  /// Before the first cycle.
  virtual void onStart() {}
  /// After the last cycle for the time being: the place to hold still what moves.
  virtual void onSuspend() {}
  /// Before the cycles go on.
  virtual void onResume() {}
  /// After the last cycle; not if the component is faulted.
  virtual void onStop() {}
  /// Before the cycles of a task go on after a fault: the place to make its members sound again.
  virtual void onRestart() {}
  /// A task's thread, before the commands of a cycle; for a device the executor's, and only of
  /// clients that do not call it directly. A client of `interface` has connected, before any of its
  /// commands is executed; or its connection has ended, and nothing of it is executed any more.
  /// Each is told once while the component runs: an end in a suspension or a fault when it goes on,
  /// and a client that came and went unseen never.
  virtual void onClient(const ProvidedBase& /*interface*/, const ConnectedClient& /*client*/,
                        ClientNews /*news*/) {}
  /// A task's thread: the client whose command is being executed; null outside of such handlers.
  const ConnectedClient* caller() const { return caller_; }

  // --- for Device and the kinds of task ---

  /// Any thread: park(), now or soon.
  virtual void parkSoon(std::string reason);
  /// Makes a legal transition to Suspended or Running happen, now or soon.
  virtual void take(Transition transition) = 0;
  /// Makes the legal `transition` here and now: the hook, the state, and what clients are told.
  void makeTransition(Transition transition);
  /// Stops what runs or is suspended, and tells all clients that they are lost.
  void endLife();

  void setEnding(bool ending) { ending_.store(ending, std::memory_order_release); }

  void claimForThisThread();
  /// This component's work is done by the thread of `lender`, which must be woken for it.
  void borrowThread(Component& lender) { lender_ = &lender; }
  void releaseThread() { owner_.store(nullptr, std::memory_order_release); }

  /// Runs the event handlers of all required interfaces on what has arrived.
  void handleEvents();

 private:
  friend class ProvidedBase;
  friend class RequiredBase;
  friend class Manager;
  friend class Task;

  /// Lets a faulted component run again, unless the hook throws.
  void restart();

  template <class Work, class Failed>
  static bool guarded(const Work& work, const Failed& failed);
  bool hasStateListener() const;
  void setStateListener(std::shared_ptr<StateListener> listener);
  void setState(ComponentState state);
  void tellListener(ComponentState state);
  /// False, and nothing has changed, if it has been parked meanwhile.
  bool changeState(ComponentState from, ComponentState to);
  void callHook(Transition transition);

  const bool ownsThread_;  // asked for each event and subscriber
  std::string name_ = "(unnamed)";
  std::atomic<std::uint64_t> faults_{0};
  std::atomic_flag parked_ = ATOMIC_FLAG_INIT;
  std::atomic<bool> ending_{false};
  std::atomic<ComponentState> state_{ComponentState::Constructed};
  std::atomic<std::int64_t> resumed_{0};  // ns; an atomic Time compiles longer
  std::vector<ProvidedBase*> provided_;
  std::vector<RequiredBase*> required_;
  rt::DueBells dueBells_;
  Component* lender_ = nullptr;
  const ConnectedClient* caller_ = nullptr;
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

template <class Work>
bool Component::parkOnThrow(const Work& work) {
  return guarded(work, [this](std::string reason) { park(std::move(reason)); });
}

template <class Work>
bool Component::parkSoonOnThrow(const Work& work) {
  return guarded(work, [this](std::string reason) { parkSoon(std::move(reason)); });
}

}  // namespace suture
