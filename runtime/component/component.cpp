#include <suture/component/channel.h>
#include <suture/component/component.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

namespace suture {
namespace {

// The address of a thread-local is the cheapest name of a thread.
const void* thisThread() {
  thread_local const char mark = 0;
  return &mark;
}

}  // namespace

Component::~Component() = default;

void Component::ringLater(rt::Doorbell& bell) {
  if (!ownsThread()) {
    bell.ring();
  } else {
    dueBells_.add(bell);
  }
}

void Component::ringNow() { dueBells_.ringAll(); }

bool Component::ownedByThisThread() {
  const void* owner = owner_.load(std::memory_order_acquire);
  if (owner == thisThread()) return true;
  if (owner != nullptr || ownsThread()) return false;
  return owner_.compare_exchange_strong(owner, thisThread());
}

void Component::claimForThisThread() { owner_.store(thisThread(), std::memory_order_release); }

void Component::park(std::string reason) {
  if (parked_.test_and_set()) return;
  fault_ = std::move(reason);
  setState(ComponentState::Faulted);
  for (ProvidedBase* provided : provided_) provided->announce(ChannelStatus::Faulted);
}

void Component::handleEvents() {
  for (RequiredBase* required : required_) required->handleEvents();
}

}  // namespace suture
