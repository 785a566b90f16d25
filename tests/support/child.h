#pragma once
// This is a process that a test starts, and ends.

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace suture {

/// Runs a program as a child process, and reads what it prints. The destructor kills it if it has
/// not been ended.
class Child {
 public:
  /// `prepare` runs in the child before the program.
  explicit Child(std::vector<std::string> arguments, const std::function<void()>& prepare = {}) {
    std::vector<char*> raw;
    for (auto& argument : arguments) raw.push_back(argument.data());
    raw.push_back(nullptr);
    int out[2];
    if (pipe2(out, O_CLOEXEC) != 0) std::abort();
    pid_ = fork();
    if (pid_ == 0) {
      dup2(out[1], STDOUT_FILENO);
      if (prepare) prepare();
      execv(raw[0], raw.data());
      _exit(127);
    }
    close(out[1]);
    output_ = out[0];
  }
  ~Child() {
    if (pid_ > 0) end(SIGKILL);
    close(output_);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Returns the next line that it prints, or as much of it as there is once the child has ended or
  /// has been silent for a minute.
  std::string line() {
    std::string text;
    char one;
    pollfd readable{output_, POLLIN, 0};
    while (poll(&readable, 1, 60'000) > 0 && read(output_, &one, 1) == 1 && one != '\n') {
      text += one;
    }
    return text;
  }
  void signal(int number) const {
    kill(pid_, number);
    if (number != SIGSTOP) return;
    siginfo_t stopped;  // it still runs for a while after the signal
    waitid(P_PID, static_cast<id_t>(pid_), &stopped, WSTOPPED | WEXITED | WNOWAIT);
  }
  pid_t pid() const { return pid_; }
  /// Sends it signal `number`, waits for its end, and returns its exit status, or minus the signal
  /// that ended it. With `number` 0 the child has to end by itself.
  int end(int number) {
    if (number != 0) signal(number);
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

 private:
  pid_t pid_ = 0;
  int output_ = -1;
};

}  // namespace suture
