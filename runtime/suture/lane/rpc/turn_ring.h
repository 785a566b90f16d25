#pragma once
// This wakes a task for what arrives together.

#include <kj/function.h>
#include <suture/loop/control_thread.h>

namespace suture::rpc {

/// Belongs to the control thread. Rings for the first of what one turn of the event loop brings, so
/// that the first waits for nothing behind it, then for every kTogether, and after the last.
class TurnRing final : private loop::EventPort::Output {
 public:
  static constexpr unsigned kTogether = 64;

  TurnRing(loop::ControlThread& control, kj::Function<void()> ring)
      : control_(control), ring_(kj::mv(ring)) {}
  ~TurnRing() { control_.port().forget(*this); }
  TurnRing(const TurnRing&) = delete;
  TurnRing& operator=(const TurnRing&) = delete;

  /// Call it when something has come.
  void arrived() {
    if (come_ == 0) control_.port().flushBeforeSleep(*this);
    if (come_++ % kTogether == 0) ring_();
  }

 private:
  void flush() override {
    come_ = 0;
    ring_();
  }

  loop::ControlThread& control_;
  kj::Function<void()> ring_;
  unsigned come_ = 0;
};

}  // namespace suture::rpc
