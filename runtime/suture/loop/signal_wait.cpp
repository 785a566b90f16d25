#include <poll.h>
#include <suture/loop/signal_wait.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <iterator>
#include <utility>

namespace suture::loop {

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

kj::AutoCloseFd SignalWait::descriptor() const {
  return kj::AutoCloseFd(signalfd(-1, &signals_, SFD_CLOEXEC | SFD_NONBLOCK));
}

OnToldToEnd::OnToldToEnd(const SignalWait& signals, std::function<void()> act)
    : told_(signals.descriptor()), act_(std::move(act)) {
  thread_ = std::thread([this] { wait(); });
}

OnToldToEnd::~OnToldToEnd() {
  over_.ring();
  thread_.join();
}

void OnToldToEnd::wait() const {
  pollfd awaited[] = {{.fd = told_, .events = POLLIN, .revents = 0},
                      {.fd = over_.get(), .events = POLLIN, .revents = 0}};
  while (poll(awaited, std::size(awaited), -1) < 0 && errno == EINTR) {
  }
  signalfd_siginfo signal;
  if (read(told_, &signal, sizeof signal) > 0) act_();
}

}  // namespace suture::loop
