#pragma once
// This learns, without signal handlers, that the process must end.

#include <kj/io.h>
#include <suture/base/time.h>
#include <suture/loop/event_descriptor.h>

#include <csignal>
#include <functional>
#include <thread>

namespace suture::loop {

/// Before any thread is started: blocks SIGINT and SIGTERM in the calling thread and those that it
/// starts, so that they can be waited for; ignores SIGPIPE.
class SignalWait {
 public:
  SignalWait();

  /// Returns true as soon as the process is told to end; false at `deadline`.
  bool endBefore(Time deadline) const;
  /// Returns a descriptor that can be read as soon as the process is told to end; reading it takes
  /// the signal.
  kj::AutoCloseFd descriptor() const;

 private:
  sigset_t signals_;
};

/// While it lives, calls `act` in another thread as soon as the process is told to end, for work
/// that cannot ask, such as waiting for other processes to appear.
class OnToldToEnd {
 public:
  OnToldToEnd(const SignalWait& signals, std::function<void()> act);
  ~OnToldToEnd();
  OnToldToEnd(const OnToldToEnd&) = delete;
  OnToldToEnd& operator=(const OnToldToEnd&) = delete;

 private:
  void wait() const;

  const kj::AutoCloseFd told_;
  const EventDescriptor over_{"wait for the signal to end"};
  const std::function<void()> act_;
  std::thread thread_;
};

}  // namespace suture::loop
