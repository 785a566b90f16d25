#pragma once
// Here a test or a replay takes the place of the kernel's clock.

#include <suture/base/time.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>

namespace suture {

/// Stands for the kernel's clock, and for its sleeping threads, while a test steps time. A process
/// has none in production; suture::TestClock is one. A thread that is about to enter the kernel in
/// order to sleep or to wake asks `virtualTime()` first. Any thread may call anything.
class VirtualTime {
 public:
  /// Names a sleeper's word in a way that all processes share, since each may map it at another
  /// address.
  using Place = std::uint64_t;

  /// Describes a thread that sleeps as long as `word` says `asleep`.
  struct Sleeper {
    Place place;
    const std::atomic<std::uint32_t>& word;
    std::uint32_t asleep;
  };

  /// Stands for the descriptors at which a thread sleeps.
  class Sockets {
   public:
    /// Only the sleeper's thread. Returns true if any of them has something to read; does not wait.
    virtual bool look() = 0;
    /// Any thread, while the sleeper sleeps. Returns false if look() would find nothing. This costs
    /// less than to wake the sleeper.
    virtual bool mayFind() = 0;

   protected:
    ~Sockets() = default;
  };

  enum class Kind : std::uint8_t { Send, Execute, Event, Status };

  virtual Time now() const = 0;
  /// Returns for how long the machine has been suspended, in which now() stood still.
  virtual Duration suspended() const = 0;

  /// Returns when the sleeper has been woken or `deadline` has come.
  virtual void sleep(const Sleeper& sleeper, Time deadline) = 0;
  /// Does the same, and returns also when `sockets` have something.
  virtual void sleepAt(Sockets& sockets, const Sleeper& sleeper, Time deadline) = 0;
  /// Wakes the thread that sleeps at `place`, if one does.
  virtual void wake(Place place) = 0;

  /// Lets the calling thread work for that long; other threads run meanwhile.
  virtual void spend(Duration duration) = 0;

  /// The thread that is about to start another one calls this; `name` shows in traces and errors.
  /// Returns what the new thread passes to begin().
  virtual std::size_t announce(const std::string& name) = 0;
  /// The new thread calls these: begin() first, and end() last.
  virtual void begin(std::size_t thread) = 0;
  virtual void end() = 0;
  /// Takes an announcement back, because the thread could not be started.
  virtual void retract(std::size_t thread) = 0;

  /// Notes what the calling thread does to `what`; `number` says which one, or which status.
  virtual void note(Kind kind, const char* interface, const char* what, std::uint64_t number) = 0;
  /// Notes that the calling thread will wake who sleeps at `place`, at the end of its cycle.
  virtual void owe(Place place) = 0;
  /// Notes that it has woken all whom it owed that.
  virtual void settle() = 0;
  /// Notes that the calling thread, `name`, found work for which nobody had rung when it woke for
  /// another reason: at a deadline that exists only for this, by a timer, or by a socket.
  virtual void missedRing(const std::string& name) = 0;

 protected:
  ~VirtualTime() = default;
};

}  // namespace suture
