#include <suture/component/required/awaited_events.h>
#include <suture/component/required/subscriptions.h>
#include <suture/rt/queue/event_queue.h>

#include <utility>

namespace suture {

AwaitedEvent::AwaitedEvent(Subscriptions& subscriptions, std::uint16_t event)
    : subscriptions_(subscriptions), event_(event), armed_(now()) {
  const Errc error = subscriptions.await(event);
  if (error == Errc{}) {
    subscriptions.awaited().add(*this);
  } else {
    end(error);
  }
}

AwaitedEvent::AwaitedEvent(AwaitedEvent&& other) noexcept
    : subscriptions_(other.subscriptions_),
      event_(other.event_),
      armed_(other.armed_),
      over_(other.over_),
      error_(other.error_) {
  if (over_) return;
  subscriptions_.awaited().remove(other);
  other.over_ = true;
  subscriptions_.awaited().add(*this);
}

AwaitedEvent::~AwaitedEvent() {
  if (!over_) subscriptions_.awaited().remove(*this);
}

void AwaitedEvent::end(Errc error) {
  over_ = true;
  error_ = error;
}

bool AwaitedEvent::over() {
  if (over_) return true;
  const Errc error = subscriptions_.end();
  if (error == Errc{}) return false;
  subscriptions_.awaited().remove(*this);
  end(error);
  return true;
}

void AwaitedEvent::wait(Duration limit) {
  if (over_) return;
  const Errc error = subscriptions_.waitFor(*this, limit);
  if (over_) return;
  subscriptions_.awaited().remove(*this);
  end(error);
}

void AwaitedEvents::add(AwaitedEvent& event) { event.next_ = std::exchange(first_, &event); }

void AwaitedEvents::remove(AwaitedEvent& event) {
  AwaitedEvent** link = &first_;
  while (*link != &event) link = &(*link)->next_;
  *link = event.next_;
}

bool AwaitedEvents::contain(std::uint16_t event) const {
  for (const AwaitedEvent* one = first_; one != nullptr; one = one->next_) {
    if (one->event_ == event) return true;
  }
  return false;
}

template <class Predicate>
void AwaitedEvents::endIf(Errc error, const Predicate& isMeant) {
  for (AwaitedEvent* one = first_; one != nullptr;) {
    AwaitedEvent* const next = one->next_;
    if (isMeant(*one)) {
      remove(*one);
      one->end(error);
    }
    one = next;
  }
}

void AwaitedEvents::endAll(Errc error) {
  endIf(error, [](const AwaitedEvent&) { return true; });
}

void AwaitedEvents::end(std::uint16_t event, Errc error) {
  endIf(error, [event](const AwaitedEvent& one) { return one.event_ == event; });
}

// Skips an event that is older than the wait: it is a replay, or was on its way.
void AwaitedEvents::satisfy(const rt::EventRecord& record) {
  endIf(Errc{}, [&record](AwaitedEvent& one) {
    if (one.event_ != record.event || record.stamp < one.armed_) return false;
    one.take(record.payload());
    return true;
  });
}

}  // namespace suture
