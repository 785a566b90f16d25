#pragma once
// This is KJ's event loop, which also acts before it sleeps.

#include <kj/async-unix.h>
#include <kj/async.h>
#include <kj/io.h>
#include <kj/timer.h>
#include <suture/rt/doorbell.h>

#include <optional>
#include <vector>

namespace suture::loop {

/// Belongs to the thread that makes it. An EventPort is the event loop of one thread, and what
/// wakes it. When KJ's queue is empty, it first brings in what other threads have handed over and
/// lets that run, then sends what all of it has written: one send for each link and turn, however
/// many messages, and no sleep while there is something to do. Its sleep and its timer follow the
/// stepped clock that the process has when it is made.
class EventPort : public kj::UnixEventPort, private VirtualTime::Sockets {
 public:
  /// An Output is collected until the loop has nothing else to do.
  class Output {
   public:
    virtual void flush() = 0;

   protected:
    ~Output() = default;
  };

  /// Hides KJ's own, which only the thread of the loop can ask if anything has happened.
  class FdObserver : public kj::UnixEventPort::FdObserver {
   public:
    FdObserver(EventPort& port, int descriptor, kj::uint asked);
    ~FdObserver() noexcept(false);
    FdObserver(const FdObserver&) = delete;
    FdObserver& operator=(const FdObserver&) = delete;

   private:
    EventPort& port_;
    const int descriptor_;
  };

  /// `bell`, if there is one, also ends the sleep. Its eventfd must be observed here.
  explicit EventPort(rt::Doorbell* bell = nullptr);

  /// Hides KJ's own, which knows only the kernel's clock.
  kj::Timer& getTimer();

  /// Returns what a promise's wait() needs.
  kj::WaitScope& scope() { return scope_; }

  /// Flushes `output` once before the loop sleeps, or after a few turns if it does not sleep.
  void flushBeforeSleep(Output& output);
  /// Stops flushing `output`, which ends.
  void forget(Output& output);

  bool wait() final;
  bool poll() final;

 protected:
  /// Makes events of what other threads have handed over.
  virtual void takeWork() {}
  /// Returns true if nothing is to run or to be sent.
  bool isIdle() { return !loop_.isRunnable() && outputs_.empty(); }

 private:
  bool bringWork();
  void flushAll();
  bool sleep();
  void sleepOnSteppedClock();
  bool look() final;
  bool mayFind() final;

  rt::Doorbell* const bell_;
  std::optional<kj::TimerImpl> steppedTimer_;
  kj::AutoCloseFd arrivals_;  // on a stepped clock: an epoll beside KJ's that any thread may ask
  std::vector<Output*> outputs_;
  unsigned busyTurns_ = 0;
  kj::EventLoop loop_{*this};
  kj::WaitScope scope_{loop_};
};

}  // namespace suture::loop
