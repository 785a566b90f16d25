#pragma once

#include <chrono>
#include <cstdint>
#include <thread>

namespace peers {

/// Returns ns of the steady clock, which all processes of a machine share.
inline std::int64_t now() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

inline constexpr std::int64_t kSecond = 1'000'000'000;

/// Asks again and again until `done()`. Returns false if it was not within `limit`.
template <class Done>
bool eventually(const Done& done, std::chrono::nanoseconds limit,
                std::chrono::nanoseconds pause = std::chrono::milliseconds(2)) {
  const std::int64_t end = now() + limit.count();
  while (!done()) {
    if (now() > end) return false;
    std::this_thread::sleep_for(pause);
  }
  return true;
}

}  // namespace peers
