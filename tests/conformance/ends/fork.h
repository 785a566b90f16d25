#pragma once
// This is a second process of the test program's own.

#include <sys/types.h>

#include <functional>
#include <memory>
#include <mutex>
#include <string>

namespace conformance {

/// A Fork is a copy of this process that does what it is asked, one thing after the other.
class Fork {
 public:
  /// A Deed is what the copy does: a function of this program, of what the copy has made and of
  /// bytes that it is sent. It answers with bytes.
  using Deed = std::string (*)(void* made, const std::string& given);

  /// `make` runs in the copy, before all deeds. Call it before this process has a second thread.
  explicit Fork(const std::function<std::shared_ptr<void>()>& make);
  /// Lets the copy destroy what it has made, and end; a failure of a test in it is one here.
  ~Fork();
  Fork(const Fork&) = delete;
  Fork& operator=(const Fork&) = delete;

  /// Any thread may call it; it returns when the deed is done.
  std::string ask(Deed deed, const std::string& given);
  pid_t pid() const { return pid_; }

 private:
  pid_t pid_ = 0;
  int socket_ = -1;
  std::mutex asking_;
};

}  // namespace conformance
