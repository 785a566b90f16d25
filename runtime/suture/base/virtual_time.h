#pragma once
// The seam at which a test or a replay takes the place of the kernel's clock.

#include <suture/base/time.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>

namespace suture {

/// Stands for the kernel's clock, and for its sleeping threads, while somebody else steps time. The
/// process has none in production; suture::TestClock is one. Whoever is about to enter the kernel
/// in order to sleep or to wake asks `virtualTime()` first. Any thread may call anything.
class VirtualTime {
 public:
  /// A sleeper's word as everybody knows it: processes may map it at different addresses.
  using Place = std::uint64_t;

  /// A thread that sleeps as long as `word` says `asleep`.
  struct Sleeper {
    Place place;
    const std::atomic<std::uint32_t>& word;
    std::uint32_t asleep;
  };

  /// The descriptors at which a thread sleeps.
  class Sockets {
   public:
    /// The sleeper's thread, without waiting: true if any of them has something for it.
    virtual bool look() = 0;
    /// Any thread, while the sleeper sleeps: false if look() would find nothing. To ask costs less
    /// than to wake the sleeper.
    virtual bool mayFind() = 0;

   protected:
    ~Sockets() = default;
  };

  enum class Kind : std::uint8_t { Send, Execute, Event, Status };

  virtual Time now() const = 0;

  /// Returns when the sleeper has been woken or `deadline` has come.
  virtual void sleep(const Sleeper& sleeper, Time deadline) = 0;
  /// The same, and also when `sockets` have something.
  virtual void sleepAt(Sockets& sockets, const Sleeper& sleeper, Time deadline) = 0;
  /// Wakes the thread that sleeps at `place`, if one does.
  virtual void wake(Place place) = 0;

  /// The calling thread works for so long; others run meanwhile.
  virtual void spend(Duration duration) = 0;

  /// The thread that is about to start another one: `name` shows in traces and errors. Returns what
  /// the new thread passes to begin().
  virtual std::size_t announce(const std::string& name) = 0;
  /// The new thread calls begin() first, and end() last.
  virtual void begin(std::size_t thread) = 0;
  virtual void end() = 0;
  /// The thread that was announced could not be started.
  virtual void retract(std::size_t thread) = 0;

  /// Notes what the calling thread does to `what`. `number`: which one, or which status.
  virtual void note(Kind kind, const char* interface, const char* what, std::uint64_t number) = 0;
  /// The calling thread, called `name`, found work when it woke at a deadline that is there only in
  /// case a ring is lost.
  virtual void missedRing(const std::string& name) = 0;

 protected:
  ~VirtualTime() = default;
};

}  // namespace suture
