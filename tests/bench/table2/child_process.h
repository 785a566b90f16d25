#pragma once
// This program once more, as another process.

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace bench {

/// Runs this program with `arguments`. It ends when its standard input ends, and leaves its result
/// on its standard output. Killed if it is still there when the object goes.
class ChildProcess {
 public:
  /// Throws SetupError if the kernel refuses.
  explicit ChildProcess(const std::vector<std::string>& arguments);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Tells the process to end, and returns what it wrote. Throws SetupError if it failed.
  std::vector<std::byte> finish();

 private:
  void closeInput();

  pid_t pid_ = -1;
  int input_ = -1;
  int output_ = -1;
};

/// In the process that is run so: returns when it is told to end.
void awaitEndOfInput();

}  // namespace bench
