#pragma once
// This lets a test that root runs be somebody else for a while.

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <thread>

namespace suture {

constexpr uid_t kNobody = 65534;

/// Runs `work` as another user, by root's right: to the kernel only its thread changes, and those
/// that it starts.
template <class Work>
void asNobody(Work work) {
  std::thread([&] {
    ASSERT_EQ(syscall(SYS_setresuid, -1, kNobody, -1), 0);
    work();
  }).join();
}

}  // namespace suture
