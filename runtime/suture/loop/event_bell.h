#pragma once
// This is the doorbell of a thread that sleeps in epoll.

#include <suture/loop/event_descriptor.h>
#include <suture/rt/doorbell.h>

#include <memory>
#include <string>

namespace suture::loop {

/// The edge of the descriptor ends the sleep of the owner, so nobody reads it. Those who ring share
/// it, and may do so after the owner is gone.
class EventBell {
 public:
  /// `asked` says what it is for. Throws SetupError if this process may have no more descriptors.
  explicit EventBell(const std::string& asked) : bell_(std::make_shared<Bell>(asked)) {}

  rt::Doorbell& doorbell() const { return bell_->doorbell; }
  std::shared_ptr<rt::Doorbell> sharedDoorbell() const { return {bell_, &bell_->doorbell}; }
  int descriptor() const { return bell_->event.get(); }

 private:
  struct Bell {
    explicit Bell(const std::string& asked) : event(asked), doorbell(event.get()) {}
    EventDescriptor event;
    rt::Doorbell doorbell;
  };

  std::shared_ptr<Bell> bell_;
};

}  // namespace suture::loop
