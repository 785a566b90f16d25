#include <suture/component/events.h>

#include <utility>

namespace suture {

Result<void> Subscription<void>::operator()(std::function<void()> handler) {
  if (handler == nullptr) return reset();
  return required_.subscribe(event_,
                             [handler = std::move(handler)](const std::byte*) { handler(); });
}

Result<void> Subscription<void>::direct(std::function<void()> handler) {
  if (handler == nullptr) return reset();
  return required_.subscribe(
      event_, [handler = std::move(handler)](const std::byte*) { handler(); }, true);
}

}  // namespace suture
