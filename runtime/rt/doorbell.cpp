#include <linux/futex.h>
#include <suture/rt/doorbell.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>

namespace suture::rt {
namespace {

timespec toTimespec(Time time) {
  const auto count = toNanoseconds(time);
  return {static_cast<time_t>(count / 1'000'000'000), static_cast<long>(count % 1'000'000'000)};
}

}  // namespace

void Doorbell::ring(RungFor what) {
  const auto bit = static_cast<std::uint32_t>(what);
  if (word_.fetch_or(bit, std::memory_order_seq_cst) != kAsleep) return;
  if (eventDescriptor_ < 0) {
    syscall(SYS_futex, &word_, FUTEX_WAKE_PRIVATE, 1, nullptr, nullptr, 0);
    return;
  }
  const std::uint64_t one = 1;
  // A full eventfd counter is as good as a write: the sleeper is due to wake.
  [[maybe_unused]] const auto written = write(eventDescriptor_, &one, sizeof(one));
}

bool Doorbell::lieDown() {
  std::uint32_t expected = kAwake;
  if (word_.compare_exchange_strong(expected, kAsleep, std::memory_order_seq_cst)) return true;
  return expected == kAsleep;
}

void Doorbell::standUp() {
  std::uint32_t expected = kAsleep;
  word_.compare_exchange_strong(expected, kAwake, std::memory_order_seq_cst);
}

RungFor Doorbell::takeRing() {
  const std::uint32_t word = word_.exchange(kAwake, std::memory_order_seq_cst);
  return static_cast<RungFor>(std::min(word & ~kAsleep, static_cast<std::uint32_t>(RungFor::Work)));
}

RungFor Doorbell::waitUntil(Time deadline) {
  const timespec until = toTimespec(deadline);
  while (lieDown()) {
    // FUTEX_WAIT_BITSET takes an absolute time on the monotonic clock.
    syscall(SYS_futex, &word_, FUTEX_WAIT_BITSET_PRIVATE, kAsleep, &until, nullptr,
            FUTEX_BITSET_MATCH_ANY);
    if (word_.load(std::memory_order_seq_cst) != kAsleep) break;
    if (now() >= deadline) return takeRing();
  }
  return takeRing();
}

}  // namespace suture::rt
