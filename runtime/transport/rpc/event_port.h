#pragma once
// KJ's event loop, with a say in what happens before it sleeps.

#include <kj/async-unix.h>
#include <kj/async.h>

#include <vector>

namespace suture::rpc {

/// The event loop of one thread, and what wakes it. When KJ's queue is empty, this first brings in
/// what other threads have handed over and lets that run, then sends what all of it has written:
/// one send a link and turn, however many messages, and no sleep while there is something to do.
/// Belongs to the thread that makes it.
class EventPort : public kj::UnixEventPort {
 public:
  /// Output that is collected until the loop has nothing else to do.
  class Output {
   public:
    virtual void flush() = 0;

   protected:
    ~Output() = default;
  };

  EventPort() = default;

  /// What a promise's wait() asks for.
  kj::WaitScope& scope() { return scope_; }

  /// `output` is flushed once before the loop sleeps, or after a few turns if it does not.
  void flushBeforeSleep(Output& output);
  /// For an output that ends: it is not flushed any more.
  void forget(Output& output);

  bool wait() final;
  bool poll() final;

 protected:
  /// Makes events of what other threads have handed over.
  virtual void takeWork() {}
  /// The last thing before sleep. False if work has come meanwhile: then the loop does not sleep.
  virtual bool lieDown() { return true; }
  /// The first thing after it.
  virtual void standUp() {}

 private:
  bool bringWork();
  void flushAll();

  std::vector<Output*> outputs_;
  unsigned busyTurns_ = 0;
  kj::EventLoop loop_{*this};
  kj::WaitScope scope_{loop_};
};

}  // namespace suture::rpc
