#pragma once
// The kernel waits on a word in memory that processes share; std::atomic's wait() is for one
// process.

#include <linux/futex.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <climits>
#include <cstdint>

namespace peers {

/// It returns when woken, after `limit`, at once if the word is not `seen`, or for no reason.
inline void futexWait(std::atomic<std::uint32_t>& word, std::uint32_t seen,
                      const timespec* limit = nullptr) {
  syscall(SYS_futex, &word, FUTEX_WAIT, seen, limit, nullptr, 0);
}

inline void futexWake(std::atomic<std::uint32_t>& word, int waiters = INT_MAX) {
  syscall(SYS_futex, &word, FUTEX_WAKE, waiters, nullptr, nullptr, 0);
}

}  // namespace peers
