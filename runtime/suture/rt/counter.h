#pragma once
// These are counters that one thread writes and any thread may read.

#include <atomic>
#include <cstdint>

namespace suture::rt {

/// Only the thread that writes the counter. With one writer no read-modify-write is needed.
inline void increment(std::atomic<std::uint64_t>& counter, std::uint64_t by = 1) {
  counter.store(counter.load(std::memory_order_relaxed) + by, std::memory_order_relaxed);
}

/// Any thread.
inline std::uint64_t count(const std::atomic<std::uint64_t>& counter) {
  return counter.load(std::memory_order_relaxed);
}

}  // namespace suture::rt
