#include <linux/futex.h>
#include <suture/base/sanitizers.h>
#include <suture/rt/doorbell.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>

#ifdef SUTURE_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace suture::rt {
namespace {

timespec toTimespec(Time time) {
  const auto count = toNanoseconds(time);
  return {static_cast<time_t>(count / 1'000'000'000), static_cast<long>(count % 1'000'000'000)};
}

// Identifies the word by its file, because the two ends of the shm lane may be in one process,
// which then maps it twice.
std::uint64_t placeOf(const MemoryBlock& memory) {
  struct stat status {};
  fstat(memory.descriptor(), &status);
  return status.st_ino;
}

#ifdef SUTURE_THREAD_SANITIZER
// ThreadSanitizer identifies memory by its address, and a word that is mapped twice has two
// addresses. This returns one address for both.
void* addressOf(const std::shared_ptr<MemoryBlock>& memory) {
  static char places[4096];
  return &places[placeOf(*memory) % sizeof(places)];
}
void tellRung(const std::shared_ptr<MemoryBlock>& memory) {
  if (memory != nullptr) __tsan_release(addressOf(memory));
}
void tellTaken(const std::shared_ptr<MemoryBlock>& memory) {
  if (memory != nullptr) __tsan_acquire(addressOf(memory));
}
#else
void tellRung(const std::shared_ptr<MemoryBlock>&) {}
void tellTaken(const std::shared_ptr<MemoryBlock>&) {}
#endif

}  // namespace

Doorbell::Doorbell(int eventDescriptor) : word_(own_), eventDescriptor_(eventDescriptor) {}

// The memory is zero at first, which means awake.
Doorbell::Doorbell(std::shared_ptr<MemoryBlock> memory, Sleeper sleeper)
    : memory_(std::move(memory)),
      shared_(sleeper == Sleeper::Elsewhere),
      word_(*reinterpret_cast<Word*>(memory_->data())) {}

// Wakes a sleeper that waits on the private futex, because later rings look for it on the shared
// one. A sleeper that is only about to wait there finds this ring in the word.
const std::shared_ptr<MemoryBlock>& Doorbell::share() {
  if (!shared_.exchange(true, std::memory_order_seq_cst)) {
    ring();
    wake(FUTEX_PRIVATE_FLAG);
  }
  return memory_;
}

int Doorbell::flavour() const {
  return shared_.load(std::memory_order_seq_cst) ? 0 : FUTEX_PRIVATE_FLAG;
}

void Doorbell::wake(int flavour) {
  syscall(SYS_futex, &word_, FUTEX_WAKE | flavour, 1, nullptr, nullptr, 0);
}

void Doorbell::ring(RungFor what) {
  tellRung(memory_);
  const auto bit = static_cast<std::uint32_t>(what);
  if (word_.fetch_or(bit, std::memory_order_seq_cst) != kAsleep) return;
  if (VirtualTime* const time = virtualTime(); time != nullptr) {
    time->wake(sleeper().place);
  } else if (eventDescriptor_ < 0) {
    wake(flavour());
  } else {
    writeEvent();
  }
}

void Doorbell::writeEvent() {
  const std::uint64_t one = 1;
  // If the counter of the eventfd is full, the write fails, but then the sleeper is woken anyway.
  [[maybe_unused]] const auto written = write(eventDescriptor_, &one, sizeof(one));
}

VirtualTime::Sleeper Doorbell::sleeper() const {
  const auto place =
      memory_ == nullptr ? reinterpret_cast<VirtualTime::Place>(&word_) : placeOf(*memory_);
  return {.place = place, .word = word_, .asleep = kAsleep};
}

bool Doorbell::prepareToSleep() {
  std::uint32_t expected = kAwake;
  if (word_.compare_exchange_strong(expected, kAsleep, std::memory_order_seq_cst)) return true;
  return expected == kAsleep;
}

void Doorbell::endSleep() {
  std::uint32_t expected = kAsleep;
  word_.compare_exchange_strong(expected, kAwake, std::memory_order_seq_cst);
}

RungFor Doorbell::takeRing() {
  const std::uint32_t word = word_.exchange(kAwake, std::memory_order_seq_cst);
  tellTaken(memory_);
  return static_cast<RungFor>(std::min(word & ~kAsleep, static_cast<std::uint32_t>(RungFor::Work)));
}

RungFor Doorbell::waitUntil(Time deadline) {
  if (shared_.load(std::memory_order_seq_cst)) deadline = std::min(deadline, now() + kLookAgain);
  const timespec until = toTimespec(deadline);
  while (prepareToSleep()) {
    if (VirtualTime* const time = virtualTime(); time != nullptr) {
      time->sleep(sleeper(), deadline);
    } else {
      // FUTEX_WAIT_BITSET takes an absolute time on the monotonic clock.
      syscall(SYS_futex, &word_, FUTEX_WAIT_BITSET | flavour(), kAsleep, &until, nullptr,
              FUTEX_BITSET_MATCH_ANY);
    }
    if (word_.load(std::memory_order_seq_cst) != kAsleep) break;
    if (now() >= deadline) return takeRing();
  }
  return takeRing();
}

void Doorbell::wait() {
  while (waitUntil(Time::max()) == RungFor::Nothing) {
  }
}

void Doorbell::sleepAt(VirtualTime::Sockets& sockets, Time deadline) {
  if (prepareToSleep()) virtualTime()->sleepAt(sockets, sleeper(), deadline);
  endSleep();
}

}  // namespace suture::rt
