#pragma once
// Being told to end, without signal handlers.

#include <kj/io.h>
#include <suture/base/time.h>

#include <csignal>
#include <functional>
#include <thread>

namespace suture {

/// Blocks SIGINT and SIGTERM in the calling thread and those it starts from now on, so that they
/// can be waited for; ignores SIGPIPE. Before any thread is started.
class SignalWait {
 public:
  SignalWait();

  /// True as soon as the process is told to end; false at `deadline`.
  bool endBefore(Time deadline) const;
  /// Can be read as soon as the process is told to end, and takes the signal by that.
  kj::AutoCloseFd descriptor() const;

 private:
  sigset_t signals_;
};

/// While it lives, calls `act` in a thread of its own as soon as the process is told to end: for
/// work that does not ask, such as waiting for other processes to appear.
class OnToldToEnd {
 public:
  OnToldToEnd(const SignalWait& signals, std::function<void()> act);
  ~OnToldToEnd();
  OnToldToEnd(const OnToldToEnd&) = delete;
  OnToldToEnd& operator=(const OnToldToEnd&) = delete;

 private:
  void wait() const;

  const kj::AutoCloseFd told_, over_;
  const std::function<void()> act_;
  std::thread thread_;
};

}  // namespace suture
