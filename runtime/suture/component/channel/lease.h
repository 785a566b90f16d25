#pragma once
// Until when a provider may execute what a client in another process has sent.

#include <suture/base/boot_time.h>

#include <atomic>

namespace suture {

/// A client that hears nothing for long enough says that its provider is lost. After that, the
/// provider's end must execute nothing of the connection, also if it was stopped as a whole
/// meanwhile: so the thread that executes looks at the clock itself, and trusts no other thread's
/// word. As long as no client has said how long it waits, there is no end.
class Lease {
 public:
  /// The control thread.
  void renew(BootTime end) { end_.store(end, std::memory_order_relaxed); }

  /// Any thread.
  BootTime end() const { return end_.load(std::memory_order_relaxed); }
  bool limited() const { return end() != BootTime::max(); }
  bool lapsed() const { return limited() && BootClock::now() >= end(); }

 private:
  std::atomic<BootTime> end_{BootTime::max()};
};

}  // namespace suture
