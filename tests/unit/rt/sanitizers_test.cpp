// Eigen comes first on purpose: it defines `__has_feature` under GCC as well, and so took from the
// header what GCC says with macros.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <suture/base/sanitizers.h>
#include <Eigen/Core>

namespace suture::rt {
namespace {

bool isLinked(const char* symbol) { return dlsym(RTLD_DEFAULT, symbol) != nullptr; }

TEST(Sanitizers, AreKnownToTheirFiles) {
#ifdef SUTURE_THREAD_SANITIZER
  EXPECT_TRUE(isLinked("__tsan_init"));
#else
  EXPECT_FALSE(isLinked("__tsan_init"));
#endif
#ifdef SUTURE_ADDRESS_SANITIZER
  EXPECT_TRUE(isLinked("__asan_init"));
#else
  EXPECT_FALSE(isLinked("__asan_init"));
#endif
}

}  // namespace
}  // namespace suture::rt
