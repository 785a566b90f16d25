#include "experiment/forked.h"

#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace experiment {
namespace {

sigset_t endSignal() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  return signals;
}

[[noreturn]] void work(const std::string& name, const std::function<void()>& what, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // it died before it could be watched
  const sigset_t signals = endSignal();
  sigprocmask(SIG_BLOCK, &signals, nullptr);
  try {
    what();
    _exit(0);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
    _exit(1);
  }
}

}  // namespace

Forked::Forked(std::string name, const std::function<void()>& what) : name_(std::move(name)) {
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) work(name_, what, parent);
  // Debian 12's <sys/pidfd.h> does not say that its functions are C's.
  if (process_ > 0) handle_ = static_cast<int>(syscall(SYS_pidfd_open, process_, 0));
  if (handle_ < 0) throw std::system_error(errno, std::generic_category(), "forking " + name_);
}

Forked::~Forked() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  close(handle_);
}

void Forked::awaitEnd() {
  const sigset_t signals = endSignal();
  int received = 0;
  sigwait(&signals, &received);
}

void Forked::end() const {
  if (process_ > 0) kill(process_, SIGTERM);
}

void Forked::requireSuccess() {
  int status = 0;
  waitpid(std::exchange(process_, -1), &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  throw std::runtime_error("the process of the " + name_ + " has failed");
}

}  // namespace experiment
