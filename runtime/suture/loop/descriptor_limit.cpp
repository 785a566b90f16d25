#include <suture/loop/descriptor_limit.h>
#include <sys/resource.h>

namespace suture::loop {

void allowAllDescriptors() {
  rlimit limit;
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_NOFILE, &limit);
}

}  // namespace suture::loop
