#pragma once
// This is this program once more, as another process.

#include <sys/types.h>

#include <cstddef>
#include <cstdio>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace bench {

/// Runs this program with `arguments`. It ends when its standard input ends, and leaves its result
/// on its standard output. The destructor kills it if it is still there.
class ChildProcess {
 public:
  /// Throws SetupError if the kernel refuses.
  explicit ChildProcess(const std::vector<std::string>& arguments);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  pid_t pid() const { return pid_; }
  /// Tells the process to end, and returns what it wrote. Throws SetupError if it failed.
  std::vector<std::byte> finish();

 private:
  void closeInput();

  pid_t pid_ = -1;
  int input_ = -1;
  int output_ = -1;
};

/// Waits, in the other process, until it is told to end.
void awaitEndOfInput();
/// Leaves values as its result, in the other process after that.
template <class T>
void writeResult(std::span<const T> values) {
  std::fwrite(values.data(), sizeof(T), values.size(), stdout);
}
/// Returns the values in what finish() returned.
template <class T>
std::vector<T> resultIn(const std::vector<std::byte>& written) {
  std::vector<T> values(written.size() / sizeof(T));
  std::memcpy(values.data(), written.data(), values.size() * sizeof(T));
  return values;
}

}  // namespace bench
