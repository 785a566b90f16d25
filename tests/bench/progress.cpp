#include "bench/progress.h"

#include <unistd.h>

#include <cstdio>

namespace bench {

void progress(const std::string& what) {
  if (isatty(STDERR_FILENO) == 0) return;
  std::fprintf(stderr, "\r\033[K%s%s", what.c_str(), what.empty() ? "" : " ...");
  std::fflush(stderr);
}

}  // namespace bench
