#include <suture/component/events.h>

#include <utility>

namespace suture {

Result<void> Emitter<void>::operator()() {
  return resultOf<void>(emission_.emit(event_, nullptr, true));
}

Result<void> SubscriptionBase::reset() {
  return resultOf<void>(subscriptions_.unsubscribe(event_));
}

Result<void> Subscription<void>::operator()(std::function<void()> handler) {
  if (handler == nullptr) return reset();
  return resultOf<void>(subscriptions_.subscribe(
      event_, [handler = std::move(handler)](const std::byte*) { handler(); }));
}

Result<void> Subscription<void>::direct(std::function<void()> handler) {
  if (handler == nullptr) return reset();
  return resultOf<void>(subscriptions_.subscribe(
      event_, [handler = std::move(handler)](const std::byte*) { handler(); }, true));
}

NextEvent<void> Subscription<void>::next() { return {subscriptions_, event_}; }

}  // namespace suture
