#pragma once
// The processes that tests start have this in common: they say "ready" and end on SIGTERM.

#include <suture/base/errors.h>

#include <csignal>
#include <cstdio>

namespace suture {

/// Tells the test, at once.
inline void say(const char* what) {
  std::puts(what);
  std::fflush(stdout);
}

/// Make this before any thread, since threads inherit the mask. Keeps SIGTERM for awaitEnd().
class HostedProcess {
 public:
  HostedProcess() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  }

  /// Says "ready", and returns when the test is done with it.
  void awaitEnd() const {
    say("ready");
    int received = 0;
    sigwait(&signals_, &received);
  }
  /// Returns true from when awaitEnd() would return at once.
  bool ended() const {
    sigset_t pending;
    sigpending(&pending);
    return sigismember(&pending, SIGTERM) == 1;
  }

 private:
  sigset_t signals_;
};

/// Returns the exit status of a process that does `work`, and says what it is refused.
template <class Work>
int statusOf(const Work& work) {
  try {
    work();
    return 0;
  } catch (const SetupError& error) {
    say(error.what());
    return 1;
  }
}

}  // namespace suture
