#pragma once
// The unit of composition: something with a name, provided and required interfaces, and perhaps a
// thread.

#include <suture/base/time.h>
#include <suture/rt/doorbell.h>

#include <atomic>
#include <string>
#include <vector>

namespace suture {

class ProvidedBase;
class RequiredBase;

enum class ComponentState : std::uint8_t { Constructed, Running, Faulted, Stopped };

/// Base of Device and Task. Its interfaces are members of the derived class that register here on
/// construction; so a component neither moves nor copies.
class Component {
 public:
  virtual ~Component();
  Component(const Component&) = delete;
  Component& operator=(const Component&) = delete;

  /// The instance name, given by the manager: unique in its process.
  const std::string& name() const { return name_; }
  ComponentState state() const { return state_.load(std::memory_order_acquire); }
  /// What the handler threw that faulted this component; "" otherwise. Stable once state() says
  /// Faulted.
  const std::string& fault() const { return fault_; }

  const std::vector<ProvidedBase*>& provided() const { return provided_; }
  const std::vector<RequiredBase*>& required() const { return required_; }

  /// True if commands and handlers run in a thread of its own; false for a device.
  virtual bool ownsThread() const = 0;
  /// How often a remote client's reads of a device are evaluated. Meaningless for a task.
  virtual Duration remoteReadPeriod() const { return Duration{0}; }

  /// Any thread: the component has failed; its clients are told Errc::Faulted from now on. The
  /// first reason stays.
  void park(std::string reason);

  /// What a sleeping owner of this component waits on.
  rt::Doorbell& doorbell() { return lender_ == nullptr ? doorbell_ : lender_->doorbell(); }
  /// From the component's own thread: rings `bell` once at the end of the cycle; from a device, at
  /// once.
  void ringLater(rt::Doorbell& bell);
  /// From the component's own thread: rings what ringLater() collected. Called before anything that
  /// blocks.
  void ringNow();

  /// True if the calling thread may use this component's required interfaces: the task's thread;
  /// for a device, the first thread that used one.
  bool ownedByThisThread();

 protected:
  Component() = default;

  void claimForThisThread();
  /// This component's work is done by the thread of `lender`, which must be woken for it.
  void borrowThread(Component& lender) { lender_ = &lender; }
  void releaseThread() { owner_.store(nullptr, std::memory_order_release); }
  void setState(ComponentState state) { state_.store(state, std::memory_order_release); }

  /// Runs the event handlers of all required interfaces on what has arrived.
  void handleEvents();

 private:
  friend class ProvidedBase;
  friend class RequiredBase;
  friend class Manager;

  std::string name_ = "(unnamed)";
  std::string fault_;
  std::atomic_flag parked_ = ATOMIC_FLAG_INIT;
  std::atomic<ComponentState> state_{ComponentState::Constructed};
  std::vector<ProvidedBase*> provided_;
  std::vector<RequiredBase*> required_;
  rt::Doorbell doorbell_;
  Component* lender_ = nullptr;
  std::vector<rt::Doorbell*> toRing_;
  std::atomic<const void*> owner_{nullptr};
};

}  // namespace suture
