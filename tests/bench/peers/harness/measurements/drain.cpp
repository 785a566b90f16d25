#include "harness/measurements/drain.h"

#include "harness/clock.h"

namespace peers {
namespace {

constexpr std::int64_t kQuiet = kSecond * 3 / 2;
// A wake-up for each pose would be counted as the peer's own work.
constexpr std::chrono::microseconds kPause{200};

}  // namespace

bool drain(const Received& received, std::uint64_t wanted) {
  std::uint64_t seen = received.count;
  std::int64_t changed = now();
  while (seen < wanted && now() - changed < kQuiet) {
    std::this_thread::sleep_for(kPause);
    if (received.count == seen) continue;
    seen = received.count;
    changed = now();
  }
  return seen >= wanted;
}

}  // namespace peers
