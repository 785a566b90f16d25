#pragma once
// This is a program that the demo starts, watches and ends.

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace demo {

/// A ChildProcess is a process that ends with this program, however this one ends. It does not
/// receive Ctrl-C, which this program handles.
class ChildProcess {
 public:
  struct Start {
    std::string title;                   ///< "process 'left'", as messages say it
    std::vector<std::string> arguments;  ///< the program's path first
    std::filesystem::path directory;     ///< where it runs
    int reportsTo;                       ///< the child's file descriptor whose output is read here
    /// If it is set, the child gets a network namespace of its own, and this is called with its
    /// process id before its program begins.
    std::function<void(pid_t)> connect;
  };

  /// Throws suture::SetupError, and what Start::connect throws.
  explicit ChildProcess(const Start& start);
  /// Kills it if it still runs.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  const std::string& title() const { return title_; }
  pid_t pid() const { return pid_; }
  /// Returns the descriptor to wait on; -1 once it has been read to its end.
  int output() const { return output_; }
  /// Returns the complete lines that have arrived. Does not block.
  std::vector<std::string> readLines();

  void signal(int number) const;
  /// Returns true if it still runs, and keeps how it ended if it has. Does not block.
  bool running();
  /// Call this once it has ended. Returns true for exit status 0.
  bool succeeded() const;
  /// Call this once it has ended. Returns for example "ended with status 1", or "was killed by
  /// signal 9 (Killed)".
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
