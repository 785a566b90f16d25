// The kernel has no room for one more thread.

#include <gtest/gtest.h>
#include <pthread.h>
#include <suture/rt/thread.h>

#include <cstddef>
#include <string>

#include "support/refusal.h"

namespace suture::rt {
namespace {

/// While it lives, a thread asks for a stack that no machine has.
class NoMoreThreads {
 public:
  NoMoreThreads() {
    pthread_getattr_default_np(&before_);
    pthread_attr_t huge = before_;
    pthread_attr_setstacksize(&huge, std::size_t{1} << 60);
    pthread_setattr_default_np(&huge);
  }
  ~NoMoreThreads() { pthread_setattr_default_np(&before_); }
  NoMoreThreads(const NoMoreThreads&) = delete;
  NoMoreThreads& operator=(const NoMoreThreads&) = delete;

 private:
  pthread_attr_t before_{};
};

TEST(Thread, AKernelsRefusalNamesTheLimits) {
  const NoMoreThreads none;
  Thread thread;
  const std::string text = refusal([&] { thread.start("Teleop", [] {}); });
  EXPECT_EQ(text.find("starting the thread of 'Teleop': the kernel gives this process no more "),
            0u)
      << text;
  EXPECT_NE(text.find("ulimit -u"), std::string::npos) << text;
  EXPECT_FALSE(thread.joinable());
}

}  // namespace
}  // namespace suture::rt
