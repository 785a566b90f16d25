#include <suture/component/events.h>

#include <utility>

namespace suture {

void Subscription<void>::operator()(std::function<void()> handler) {
  required_.handlers_[event_] = [handler = std::move(handler)](const std::byte*) { handler(); };
  required_.subscribed_ |= EventSet{1} << event_;
}

}  // namespace suture
