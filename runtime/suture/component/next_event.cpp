#include <suture/component/channel/channel.h>
#include <suture/component/next_event.h>
#include <suture/component/required_tables.h>
#include <suture/component/sleep.h>

namespace suture {

AwaitedEvent::AwaitedEvent(RequiredBase& required, std::uint16_t event)
    : required_(required), event_(event), armed_(now()) {
  if (const Errc error = required.arm(*this); error != Errc{}) end(error);
}

AwaitedEvent::AwaitedEvent(AwaitedEvent&& other) noexcept
    : required_(other.required_),
      event_(other.event_),
      armed_(other.armed_),
      over_(other.over_),
      error_(other.error_) {
  if (over_) return;
  other.unlink();
  other.over_ = true;
  next_ = std::exchange(required_.awaited_, this);
}

AwaitedEvent::~AwaitedEvent() {
  if (!over_) unlink();
}

void AwaitedEvent::unlink() {
  AwaitedEvent** link = &required_.awaited_;
  while (*link != this) link = &(*link)->next_;
  *link = next_;
}

void AwaitedEvent::end(Errc error) {
  over_ = true;
  error_ = error;
}

bool AwaitedEvent::over() {
  if (over_) return true;
  const Errc error = required_.endOfEvents();
  if (error == Errc{}) return false;
  unlink();
  end(error);
  return true;
}

void AwaitedEvent::wait(Duration limit) {
  if (over_) return;
  Component& owner = required_.owner();
  Errc error = Errc::CannotWait;
  if (owner.ownedByAnotherThread()) {
    error = Errc::WrongThread;
  } else if (!required_.handling_) {
    error = Errc::Timeout;
    sleepUntil(owner, now() + limit, [this] {
      const std::size_t handled = required_.handleArrivals();
      const bool isOver = over();
      if (handled > (isOver ? 1u : 0u)) required_.handledInWait_ = true;
      return isOver;
    });
  }
  if (over_) return;
  unlink();
  end(error);
}

// --- what RequiredBase does for it

Errc RequiredBase::arm(AwaitedEvent& event) {
  const Errc error = unusable();
  if (error != Errc{} && error != Errc::Suspended) return error;
  const Tables::HeardEvent& heard = tables_->events[event.event_];
  if (heard.direct && channel_->ends.here != nullptr) return Errc::CannotWait;
  event.next_ = std::exchange(awaited_, &event);
  const EventSet bit = EventSet{1} << event.event_;
  const bool joins = (subscribed() & bit) == 0;
  subscribed_.fetch_or(bit, std::memory_order_relaxed);
  passSubscriptionsOn(joins ? bit : 0);
  return Errc{};
}

// Ends each at most once, since what is over is no longer in the list.
template <class Whether>
void RequiredBase::endAwaited(Errc error, const Whether& whether) {
  for (AwaitedEvent* one = awaited_; one != nullptr;) {
    AwaitedEvent* const next = one->next_;
    if (whether(*one)) {
      one->unlink();
      one->end(error);
    }
    one = next;
  }
}

void RequiredBase::loseAwaited() {
  endAwaited(Errc::Lost, [](const AwaitedEvent&) { return true; });
}

void RequiredBase::refuseAwaited(std::uint16_t event) {
  endAwaited(Errc::CannotWait, [event](const AwaitedEvent& one) { return one.event_ == event; });
}

// Skips an event that is older than the wait: it is a replay, or was on its way.
void RequiredBase::satisfyAwaited(const rt::EventRecord& record) {
  endAwaited(Errc{}, [&record](AwaitedEvent& one) {
    if (one.event_ != record.event || record.stamp < one.armed_) return false;
    one.take(record.payload());
    return true;
  });
}

bool RequiredBase::isAwaited(std::uint16_t event) const {
  for (const AwaitedEvent* one = awaited_; one != nullptr; one = one->next_) {
    if (one->event_ == event) return true;
  }
  return false;
}

Errc RequiredBase::endOfEvents() const {
  if (channel_ == nullptr) return Errc::Lost;
  const ChannelStatus status = channel_->status.load(std::memory_order_acquire);
  const bool over = status != ChannelStatus::Connected && status != ChannelStatus::Suspended;
  // Events that were emitted before the end are handled before it.
  if (!over || channel_->events.pending()) return Errc{};
  return status == ChannelStatus::Faulted ? Errc::Faulted : Errc::Lost;
}

// Does as a cycle does first; but a task's connections change between its cycles only.
std::size_t RequiredBase::handleArrivals() {
  if (!owner_.ownsThread()) adopt();
  noticeLoss();
  return handleQueuedEvents();
}

}  // namespace suture
