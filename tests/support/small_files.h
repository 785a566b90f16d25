#pragma once

#include <sys/resource.h>

#include <csignal>

namespace suture {

/// While one exists, this process can make no file longer than `bytes`. write() fails there as on a
/// full disk, but with another reason.
class SmallFiles {
 public:
  explicit SmallFiles(rlim_t bytes) : before_(std::signal(SIGXFSZ, SIG_IGN)) { limit(bytes); }
  ~SmallFiles() {
    limit(RLIM_INFINITY);
    std::signal(SIGXFSZ, before_);
  }
  SmallFiles(const SmallFiles&) = delete;
  SmallFiles& operator=(const SmallFiles&) = delete;

 private:
  static void limit(rlim_t bytes) {
    const rlimit limit{.rlim_cur = bytes, .rlim_max = RLIM_INFINITY};
    setrlimit(RLIMIT_FSIZE, &limit);
  }

  void (*const before_)(int);
};

}  // namespace suture
