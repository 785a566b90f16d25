#pragma once
// These are the events that a caller waits for.

#include <suture/base/errors.h>
#include <suture/base/time.h>

#include <cstddef>
#include <cstdint>

namespace suture::rt {
struct EventRecord;
}

namespace suture {

class AwaitedEvents;
class Subscriptions;

/// An AwaitedEvent is a NextEvent without its payload. Belongs to the thread of the component.
class AwaitedEvent {
 public:
  AwaitedEvent(const AwaitedEvent&) = delete;
  AwaitedEvent& operator=(const AwaitedEvent&) = delete;

  /// Returns true if the event has come or cannot come any more.
  bool over();

 protected:
  /// Begins to await the event.
  AwaitedEvent(Subscriptions& subscriptions, std::uint16_t event);
  /// Takes the place of `other`, which must not be used any more.
  AwaitedEvent(AwaitedEvent&& other) noexcept;
  ~AwaitedEvent();

  /// Handles what arrives until the event is over, at most for `limit`; then it ends with
  /// Errc::Timeout, or with Cancelled if its component stops.
  void wait(Duration limit);
  /// Returns why it has not come, or 0 if it has.
  Errc error() const { return error_; }

  virtual void take(const std::byte* payload) = 0;

 private:
  friend class AwaitedEvents;

  void end(Errc error);

  Subscriptions& subscriptions_;
  std::uint16_t event_;
  Time armed_;
  bool over_ = false;
  Errc error_{};
  AwaitedEvent* next_ = nullptr;  // the required interface lists them
};

/// Lists the awaited events of one required interface. They link themselves, so that nothing is
/// allocated. Each is ended at most once, since it leaves the list when it is over.
class AwaitedEvents {
 public:
  void add(AwaitedEvent& event);
  void remove(AwaitedEvent& event);
  bool contain(std::uint16_t event) const;

  void endAll(Errc error);
  /// Ends those of `event`.
  void end(std::uint16_t event, Errc error);
  /// Ends those that wait for `record`, and gives it to them.
  void satisfy(const rt::EventRecord& record);

 private:
  template <class Predicate>
  void endIf(Errc error, const Predicate& isMeant);

  AwaitedEvent* first_ = nullptr;
};

}  // namespace suture
