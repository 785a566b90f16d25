#pragma once
// A program that the demo starts, watches and ends.

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace demo {

/// Ends with this program, however this one ends; does not hear Ctrl-C, which is this one's to
/// handle.
class ChildProcess {
 public:
  struct Start {
    std::string title;                   ///< for messages: "process 'left'"
    std::vector<std::string> arguments;  ///< the program's path first
    std::filesystem::path directory;     ///< where it runs
    int reportsTo;                       ///< the child's file descriptor whose output is read here
    /// If there is one, the child gets a network namespace of its own, and this is called with its
    /// process id before its program begins.
    std::function<void(pid_t)> connect;
  };

  /// Throws std::system_error, and what Start::connect throws.
  explicit ChildProcess(const Start& start);
  /// Kills it if it still runs.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  const std::string& title() const { return title_; }
  pid_t pid() const { return pid_; }
  /// To wait on; -1 once it has been read to its end.
  int output() const { return output_; }
  /// The complete lines that have arrived. Does not block.
  std::vector<std::string> readLines();

  void signal(int number) const;
  /// Takes notice of its end, if it has ended. Does not block.
  bool running();
  /// Once it has ended: true for exit status 0.
  bool succeeded() const;
  /// Once it has ended: "ended with status 1", "was killed by signal 9 (Killed)".
  std::string ending() const;

 private:
  void kill();

  std::string title_;
  pid_t pid_ = -1;
  int output_ = -1;
  std::string partialLine_;
  bool running_ = true;
  int status_ = 0;
};

}  // namespace demo
