#pragma once
// Being told to end, without signal handlers.

#include <suture/base/time.h>

#include <csignal>
#include <functional>
#include <stop_token>
#include <thread>

namespace suture {

/// Blocks SIGINT and SIGTERM in the calling thread and those it starts from now on, so that they
/// can be waited for; ignores SIGPIPE. Before any thread is started.
class SignalWait {
 public:
  SignalWait();

  /// True as soon as the process is told to end; false at `deadline`.
  bool endBefore(Time deadline) const;

 private:
  sigset_t signals_;
};

/// While it lives, calls `act` in a thread of its own as soon as the process is told to end: for
/// work that does not ask, such as waiting for other processes to appear.
class OnToldToEnd {
 public:
  /// `signals` outlives this.
  OnToldToEnd(const SignalWait& signals, std::function<void()> act);

 private:
  std::jthread thread_;
};

}  // namespace suture
