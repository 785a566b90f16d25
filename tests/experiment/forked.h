#pragma once
// This is a process that does a part of this program's work.

#include <sys/types.h>

#include <functional>
#include <string>

namespace experiment {

/// Ends with this program, however that ends. It is forked, so that it needs no program of its own:
/// only a process without other threads may make one.
class Forked {
 public:
  /// `work` runs there; what it throws goes to standard error. SIGTERM is blocked for it:
  /// awaitEnd() returns at one. Throws std::system_error.
  Forked(std::string name, const std::function<void()>& work);
  /// Kills it if it still runs.
  ~Forked();
  Forked(const Forked&) = delete;
  Forked& operator=(const Forked&) = delete;

  /// Returns in its work once the other process has called end().
  static void awaitEnd();

  /// Can be read once it has ended.
  int handle() const { return handle_; }
  void end() const;
  /// Call it once it has ended. Throws std::runtime_error if its work did.
  void requireSuccess();

 private:
  const std::string name_;
  pid_t process_ = -1;
  int handle_ = -1;
};

}  // namespace experiment
