#include <gtest/gtest.h>
#include <suture/loop/signal_wait.h>

#include "support/no_more_descriptors.h"
#include "support/refusal.h"

namespace suture::loop {
namespace {

// Without a descriptor, its end would wait forever for its thread.
TEST(OnToldToEnd, SaysWhyItCannotWait) {
  const SignalWait signals;
  EXPECT_EQ(refusal([&] {
              const NoMoreDescriptors full;
              const OnToldToEnd told(signals, [] {});
            }),
            "wait for the signal to end: eventfd: Too many open files. Raise the limit of open "
            "files (ulimit -n).");
}

}  // namespace
}  // namespace suture::loop
