#include <suture/deploy/signal_wait.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <utility>

namespace suture {

using namespace std::chrono_literals;

SignalWait::SignalWait() {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
}

bool SignalWait::endBefore(Time deadline) const {
  while (true) {
    const Duration left = std::max(deadline - now(), Duration{0});
    const timespec timeout{.tv_sec = left / 1s, .tv_nsec = (left % 1s).count()};
    if (sigtimedwait(&signals_, nullptr, &timeout) > 0) return true;
    if (errno != EINTR) return false;
  }
}

OnToldToEnd::OnToldToEnd(const SignalWait& signals, std::function<void()> act)
    : thread_([&signals, act = std::move(act)](std::stop_token stop) {
        while (!stop.stop_requested()) {
          if (signals.endBefore(now() + 20ms)) return act();
        }
      }) {}

}  // namespace suture
