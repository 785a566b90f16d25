#pragma once
// This takes from a test's process what a full table of descriptors would.

#include <fcntl.h>
#include <kj/io.h>
#include <sys/resource.h>

namespace suture {

/// Leaves this process no descriptor more than it has.
class NoMoreDescriptors {
 public:
  NoMoreDescriptors() {
    getrlimit(RLIMIT_NOFILE, &before_);
    const kj::AutoCloseFd next(::open("/dev/null", O_RDONLY | O_CLOEXEC));
    setLimit(static_cast<rlim_t>(next.get()));
  }
  ~NoMoreDescriptors() { setLimit(before_.rlim_cur); }
  NoMoreDescriptors(const NoMoreDescriptors&) = delete;
  NoMoreDescriptors& operator=(const NoMoreDescriptors&) = delete;

 private:
  void setLimit(rlim_t most) const {
    const rlimit limit{most, before_.rlim_max};
    setrlimit(RLIMIT_NOFILE, &limit);
  }

  rlimit before_{};
};

}  // namespace suture
