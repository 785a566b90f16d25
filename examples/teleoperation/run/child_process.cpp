#include "run/child_process.h"

#include <fcntl.h>
#include <sched.h>
#include <suture/base/errors.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <utility>

namespace demo {
namespace {

[[noreturn]] void refuse(const std::string& title, int error) {
  throw suture::SetupError("start " + title, std::strerror(error),
                           "Raise the limits of this user (ulimit -n for descriptors, ulimit -u "
                           "for processes), or end something");
}

/// This is a line with two ends by which parent and child wait for each other.
struct Line {
  explicit Line(const std::string& title) {
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) refuse(title, errno);
  }
  ~Line() {
    for (const int end : ends) close(end);
  }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  void signal(int end) const { [[maybe_unused]] const ssize_t sent = write(ends[end], "", 1); }
  /// Waits for the other end. Returns false if it is gone.
  bool await(int end) {
    close(std::exchange(ends[1 - end], -1));
    char byte;
    ssize_t count;
    do count = read(ends[end], &byte, 1);
    while (count < 0 && errno == EINTR);
    return count == 1;
  }

  std::array<int, 2> ends{};
};
constexpr int kParent = 0, kChild = 1;

/// Enters a network namespace of its own, and returns when the parent has connected it.
void enterOwnNetwork(Line& line, const std::string& title) {
  if (unshare(CLONE_NEWNET) != 0) {
    std::fprintf(
        stderr, "%s gets no network namespace: %s. Run this as root, or choose another --network\n",
        title.c_str(), std::strerror(errno));
    _exit(127);
  }
  line.signal(kChild);
  if (!line.await(kChild)) _exit(1);
}

[[noreturn]] void becomeProgram(const ChildProcess::Start& start, int pipe, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);   // a frozen process handles no other signal
  if (getppid() != parent) _exit(1);  // the parent died before it could be watched
  setpgid(0, 0);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  if (pipe == start.reportsTo) {
    fcntl(pipe, F_SETFD, 0);  // stays open in the program
  } else {
    dup2(pipe, start.reportsTo);
  }
  std::vector<char*> arguments;
  for (const std::string& argument : start.arguments) {
    arguments.push_back(const_cast<char*>(argument.c_str()));
  }
  arguments.push_back(nullptr);
  if (chdir(start.directory.c_str()) == 0) execv(arguments[0], arguments.data());
  std::fprintf(stderr,
               "%s cannot be started: %s: %s. Build that program; it has to be beside this one\n",
               start.title.c_str(), arguments[0], std::strerror(errno));
  _exit(127);
}

}  // namespace

ChildProcess::ChildProcess(const Start& start) : title_(start.title) {
  Line line(title_);
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) refuse(title_, errno);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) {
    if (start.connect) enterOwnNetwork(line, title_);
    becomeProgram(start, ends[1], parent);
  }
  const int error = errno;
  close(ends[1]);
  output_ = ends[0];
  fcntl(output_, F_SETFL, O_NONBLOCK);
  if (pid_ < 0) {
    close(output_);
    refuse(title_, error);
  }
  if (!start.connect || !line.await(kParent)) return;  // the end of a child is noticed later
  try {
    start.connect(pid_);
  } catch (...) {
    kill();
    throw;
  }
  line.signal(kParent);
}

ChildProcess::~ChildProcess() { kill(); }

void ChildProcess::kill() {
  if (running()) {
    signal(SIGKILL);
    waitpid(pid_, &status_, 0);
  }
  if (output_ >= 0) close(output_);
}

std::vector<std::string> ChildProcess::readLines() {
  std::array<char, 65536> buffer;
  while (output_ >= 0) {
    const ssize_t count = read(output_, buffer.data(), buffer.size());
    if (count > 0) {
      partialLine_.append(buffer.data(), static_cast<std::size_t>(count));
    } else if (count < 0 && errno == EINTR) {
      continue;
    } else {
      if (count == 0) {
        close(output_);
        output_ = -1;
      }
      break;
    }
  }
  std::vector<std::string> lines;
  std::size_t begin = 0;
  for (std::size_t end; (end = partialLine_.find('\n', begin)) != std::string::npos;
       begin = end + 1) {
    lines.push_back(partialLine_.substr(begin, end - begin));
  }
  partialLine_.erase(0, begin);
  return lines;
}

void ChildProcess::signal(int number) const {
  if (running_) ::kill(pid_, number);
}

bool ChildProcess::running() {
  if (running_ && waitpid(pid_, &status_, WNOHANG) == pid_) running_ = false;
  return running_;
}

bool ChildProcess::succeeded() const { return WIFEXITED(status_) && WEXITSTATUS(status_) == 0; }

std::string ChildProcess::ending() const {
  if (WIFEXITED(status_)) return "ended with status " + std::to_string(WEXITSTATUS(status_));
  const int number = WTERMSIG(status_);
  return "was killed by signal " + std::to_string(number) + " (" + strsignal(number) + ")";
}

}  // namespace demo
