#include <pthread.h>
#include <suture/base/errors.h>
#include <suture/component/channel/channel.h>
#include <suture/component/component.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include <algorithm>
#include <mutex>

namespace suture {
namespace {

// Identifies a thread by the same value in the program and in each library that it loads. Each may
// have a copy of this file, so a variable of this file could not identify one.
const void* thisThread() {
  return reinterpret_cast<const void*>(pthread_self());  // NOLINT(performance-no-int-to-ptr)
}

}  // namespace

// Holds what no other file needs to compile, and what may be rung after the component is gone.
struct Component::Aside {
  rt::Doorbell doorbell{std::make_shared<MemoryBlock>("suture-doorbell", sizeof(std::uint64_t)),
                        rt::Doorbell::Sleeper::Here};
  std::mutex mutex;  // guards the next two, of which one thread may park and another may ask
  std::string fault;
  FaultCause cause = FaultCause::Code;
  std::shared_ptr<StateListener> listener;
};

Component::Component(bool ownsThread)
    : ownsThread_(ownsThread), aside_(std::make_shared<Aside>()), doorbell_(aside_->doorbell) {}

// Drops the listener, which refers to this; a thread that may still ring keeps the rest.
Component::~Component() { aside_->listener = nullptr; }

std::shared_ptr<rt::Doorbell> Component::sharedDoorbell() {
  if (lender_ != nullptr) return lender_->sharedDoorbell();
  return {aside_, &doorbell_};
}

void Component::ringLater(rt::Doorbell& bell) {
  if (!ownsThread()) {
    bell.ring();
  } else {
    dueBells_.add(bell);
  }
}

void Component::ringForArrival(Channel& channel) {
  channel.provider.untaken().raise(std::memory_order_release);
  rt::Doorbell& bell = *channel.ends.client;
  if (!ownsThread()) {
    bell.ring(rt::RungFor::Arrival);
  } else {
    dueBells_.add(bell, rt::RungFor::Arrival, &channel.provider.untaken());
  }
}

void Component::ringNow() { dueBells_.ringAll(); }

bool Component::ownedByThisThread() {
  const void* owner = owner_.load(std::memory_order_acquire);
  if (owner == thisThread()) return true;
  if (owner != nullptr || ownsThread()) return false;
  return owner_.compare_exchange_strong(owner, thisThread());
}

bool Component::mayRunHandlers() const {
  return statusIn(state_.load(std::memory_order_seq_cst)) == ChannelStatus::Connected;
}

bool Component::hasCycles() const {
  const ComponentState present = state();
  const bool begun =
      present != ComponentState::Constructed && present != ComponentState::Configured;
  return ownsThread() && begun && !ending();
}

bool Component::ownedByAnotherThread() const {
  const void* owner = owner_.load(std::memory_order_acquire);
  return owner != nullptr && owner != thisThread();
}

void Component::claimForThisThread() { owner_.store(thisThread(), std::memory_order_release); }

void Component::configure() {
  requireLegal(name_, state(), Transition::Configure);
  makeTransition(Transition::Configure);
  ringNow();
}

void Component::request(Transition transition) {
  if (transition != Transition::Suspend && transition != Transition::Resume) {
    throw SetupError(
        "component '" + name_ + "' was asked to " + toString(transition),
        "that is for whoever gave it its thread",
        "Call configure(), start() or stop(); only suspend and resume can be asked for");
  }
  requireLegal(name_, state(), transition);
  take(transition);
}

void Component::makeTransition(Transition transition) {
  const ComponentState from = state();
  const auto to = after(from, transition);
  if (!to) return;  // a device was parked after this was requested
  if (transition != Transition::Restart) meantToRun_ = transition == Transition::Resume;
  if (!parkOnThrow([&] { runHook([&] { callHook(transition); }); })) return;
  if (transition == Transition::Resume || transition == Transition::Restart) {
    resumed_.store(toNanoseconds(now()), std::memory_order_release);
  }
  if (!changeState(from, *to)) return;
  meantToRun_ = *to == ComponentState::Running;
  // endLife() tells the clients whose connection a stop has ended, and a start tells those that
  // have connected since then.
  if (transition != Transition::Configure && transition != Transition::Stop) {
    for (ProvidedBase* provided : provided_) provided->announce(statusIn(state()));
  }
}

void Component::callHook(Transition transition) {
  switch (transition) {
    case Transition::Configure: onConfigure(); break;
    case Transition::Start: onStart(); break;
    case Transition::Suspend: onSuspend(); break;
    case Transition::Resume: onResume(); break;
    case Transition::Stop: onStop(); break;
    case Transition::Restart: onRestart(); break;
  }
}

bool Component::holdsUp(std::string_view component) const {
  if (!ownsThread()) return false;
  const bool called = caller_ != nullptr && Channel::componentOf(caller_->name) == component;
  return called || std::any_of(provided_.begin(), provided_.end(), [=](const ProvidedBase* one) {
           return one->pendingFrom(component);
         });
}

void Component::endLife() {
  if (after(state(), Transition::Stop)) makeTransition(Transition::Stop);
  if (ownsThread()) {  // a device's thread is not this one; its interfaces wait for handlers when
                       // they end
    for (const RequiredBase* required : required_) required->awaitDirectHandlers();
  }
  ringNow();
  for (ProvidedBase* provided : provided_) provided->announce(ChannelStatus::Lost);
}

// attach() adds its channel before it looks at the state. Both are sequentially consistent, so
// either it or this tells the client.
void Component::setState(ComponentState state) {
  state_.store(state, std::memory_order_seq_cst);
  tellListener(state);
}

void Component::setStateListener(std::shared_ptr<StateListener> listener) {
  aside_->listener = std::move(listener);
}

void Component::tellListener(ComponentState state) {
  if (aside_->listener != nullptr) aside_->listener->stateChanged(state);
}

// Changes nothing if the component was parked meanwhile: by a read in the hook, as the contract of
// a connection says, or by a client's call of a device.
bool Component::changeState(ComponentState from, ComponentState to) {
  if (parked_.test()) return false;
  if (!state_.compare_exchange_strong(from, to, std::memory_order_seq_cst)) return false;
  tellListener(to);
  return true;
}

void Component::park(std::string reason, FaultCause cause) {
  if (parked_.test_and_set()) return;
  {
    const std::lock_guard lock(aside_->mutex);
    aside_->fault = std::move(reason);
    aside_->cause = cause;
  }
  // Set the state first: a new count beside a running component would look like a restart.
  setState(ComponentState::Faulted);
  faults_.fetch_add(1, std::memory_order_release);
  for (ProvidedBase* provided : provided_) provided->announce(ChannelStatus::Faulted);
}

void Component::parkSoon(std::string reason) { park(std::move(reason)); }

std::string Component::fault() const {
  const std::lock_guard lock(aside_->mutex);
  return aside_->fault;
}

FaultCause Component::faultCause() const {
  const std::lock_guard lock(aside_->mutex);
  return aside_->cause;
}

std::string Component::whyFaulted() const {
  const std::lock_guard lock(aside_->mutex);
  return aside_->cause == FaultCause::Code ? "its code threw: " + aside_->fault : aside_->fault;
}

void Component::restart() {
  parked_.clear();
  makeTransition(Transition::Restart);
}

void Component::handleEvents() {
  const ComponentState before = state();
  for (RequiredBase* required : required_) required->updateConnection();
  for (RequiredBase* required : required_) {
    // the contract of a connection has parked it, or it is asked to stop
    if (state() != before || ending()) return;
    required->handleEvents();
  }
}

}  // namespace suture
