#pragma once
// This is the one thread of a process that runs KJ and Cap'n Proto.

#include <kj/async.h>
#include <kj/function.h>
#include <suture/base/time.h>
#include <suture/loop/event_bell.h>
#include <suture/loop/event_port.h>
#include <suture/loop/outcome.h>
#include <suture/rt/thread.h>

#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace suture::loop {

/// Moves data between task threads and the network whenever a task has rung.
class Pump {
 public:
  virtual ~Pump() noexcept(false) = default;
  /// The control thread. Takes everything that waits. Must not block.
  virtual void pump() = 0;
};

/// Owns an event loop and its thread. Objects that are made on it must be destroyed on it (or by
/// its tasks) before it ends. All signals are blocked in it. Construction throws SetupError if the
/// kernel refuses.
class ControlThread {
 public:
  ControlThread();
  /// Cancels all tasks, fails what waits in run() and joins.
  ~ControlThread() noexcept;
  ControlThread(const ControlThread&) = delete;
  ControlThread& operator=(const ControlThread&) = delete;

  /// Any thread. Runs `work` on the control thread soon, in the order of posting. Work that has not
  /// started when this object ends is destroyed without running.
  void post(kj::Function<void()> work);

  /// Any other thread. Runs `work` there and waits for its result, or for that of the promise that
  /// it returns, at most for `deadline`; then the promise is cancelled. Throws ControlFailure.
  /// `work` must own what it uses.
  template <class Work>
  auto run(Duration deadline, Work work) {
    using Value = kj::_::UnwrapPromise<decltype(kj::evalLater(work))>;
    requireOther();
    auto outcome = std::make_shared<Outcome<Value>>();
    post([this, deadline, settles = Settles<Value>(outcome), work = std::move(work)]() mutable {
      auto held = kj::heap(std::move(work));
      auto done = kj::evalLater([&work = *held] { return work(); }).attach(kj::mv(held));
      spawn(settles.follow(timer().timeoutAfter(deadline.count() * kj::NANOSECONDS, kj::mv(done))));
    });
    return outcome->wait(deadline);
  }

  /// Any thread rings it when a pump has something to take.
  rt::Doorbell& doorbell() { return bell_.doorbell(); }
  /// Returns the same doorbell for those who may ring it after this object is gone.
  std::shared_ptr<rt::Doorbell> sharedDoorbell() { return bell_.sharedDoorbell(); }

  /// The rest is only for the control thread.
  bool isCurrent() const { return thread_.isCurrent(); }
  EventPort& port() { return *loop_; }
  kj::Timer& timer() { return loop_->getTimer(); }
  /// Keeps a promise running until it ends or the thread does. Reports a failure on standard error.
  void spawn(kj::Promise<void> task) { loop_->tasks.add(kj::mv(task)); }
  void add(Pump& pump);
  /// May be called from within a pump.
  void remove(Pump& pump);

 private:
  /// Handles the doorbell whenever KJ has nothing to do.
  struct Loop final : EventPort, kj::TaskSet::ErrorHandler {
    explicit Loop(ControlThread& owner);
    void runUntilStopped();
    void report(const kj::Exception& exception);

    void takeWork() override;
    void requireRing();
    void taskFailed(kj::Exception&& exception) override { report(exception); }

    ControlThread& owner;
    FdObserver rung;
    kj::Own<kj::PromiseFulfiller<void>> stop;
    kj::TaskSet tasks;
  };

  void serve();
  void requireOther() const;
  void runPosted();
  void runPumps();

  const EventBell bell_{"start the control thread"};
  std::mutex mutex_;  // never taken by a task thread
  std::vector<kj::Function<void()>> posted_;
  std::atomic<bool> anyPosted_{false};
  std::vector<Pump*> pumps_;
  Loop* loop_ = nullptr;
  std::exception_ptr whyNot_;  // there is no loop
  rt::Doorbell started_;
  rt::Thread thread_;
};

}  // namespace suture::loop
