#pragma once
// Being told to end, without signal handlers.

#include <suture/base/time.h>

#include <csignal>
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

/// While it lives, being told to end ends the process at once, with status 0: for work that cannot
/// be interrupted, such as waiting for other processes to appear.
class ExitOnSignal {
 public:
  explicit ExitOnSignal(const SignalWait& signals);

 private:
  std::jthread thread_;
};

}  // namespace suture
