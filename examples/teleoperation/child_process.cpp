#include "child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <system_error>

namespace demo {
namespace {

[[noreturn]] void becomeProgram(const ChildProcess::Start& start, int pipe, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(1);  // it died before it could be watched
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
  std::fprintf(stderr, "%s cannot be started: %s: %s\n", start.title.c_str(), arguments[0],
               std::strerror(errno));
  _exit(127);
}

}  // namespace

ChildProcess::ChildProcess(const Start& start) : title_(start.title) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw std::system_error(errno, std::generic_category(), "a pipe for " + title_);
  }
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) becomeProgram(start, ends[1], parent);
  const int error = errno;
  close(ends[1]);
  output_ = ends[0];
  fcntl(output_, F_SETFL, O_NONBLOCK);
  if (pid_ < 0) throw std::system_error(error, std::generic_category(), "starting " + title_);
}

ChildProcess::~ChildProcess() {
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
  if (running_) kill(pid_, number);
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
