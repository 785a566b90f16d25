#pragma once
// Somebody waits for these events.

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

/// A NextEvent without its payload. Belongs to the thread of the component.
class AwaitedEvent {
 public:
  AwaitedEvent(const AwaitedEvent&) = delete;
  AwaitedEvent& operator=(const AwaitedEvent&) = delete;

  /// True if the event has come or cannot come any more.
  bool over();

 protected:
  /// It is awaited from now on.
  AwaitedEvent(Subscriptions& subscriptions, std::uint16_t event);
  /// Takes the place of `other`, which must not be used any more.
  AwaitedEvent(AwaitedEvent&& other) noexcept;
  ~AwaitedEvent();

  /// Handles what arrives until it is over, at most for `limit`; then that is its end.
  void wait(Duration limit);
  /// Why it has not come; 0: it has.
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
  AwaitedEvent* next_ = nullptr;  // of the same required interface
};

/// Those of one required interface. They link themselves, so that nothing is allocated; each is
/// ended at most once, since what is over is no longer among them.
class AwaitedEvents {
 public:
  void add(AwaitedEvent& event);
  void remove(AwaitedEvent& event);
  bool contain(std::uint16_t event) const;

  void endAll(Errc error);
  /// Ends those of `event`.
  void end(std::uint16_t event, Errc error);
  /// Ends those that `record` is for, which get it.
  void satisfy(const rt::EventRecord& record);

 private:
  template <class Whether>
  void endIf(Errc error, const Whether& whether);

  AwaitedEvent* first_ = nullptr;
};

}  // namespace suture
