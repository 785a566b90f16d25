#include "support/allocations.h"

#include <suture/base/sanitizers.h>
#include <sys/prctl.h>

#include <atomic>
#include <cstddef>
#include <cstring>

namespace {

thread_local std::uint64_t count = 0;
std::atomic<const char*> wantedName{nullptr};
std::atomic<std::uint64_t> countOfNamed{0};

// The kernel is asked: a thread has allocated before it gives itself its name.
[[maybe_unused]] void countOne() {
  ++count;
  const char* const wanted = wantedName.load(std::memory_order_acquire);
  if (wanted == nullptr) return;
  char own[16] = {};
  prctl(PR_GET_NAME, own);
  if (std::strcmp(own, wanted) == 0) countOfNamed.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace

#if defined(SUTURE_ADDRESS_SANITIZER) || defined(SUTURE_THREAD_SANITIZER)
constexpr bool kCounts = false;
#else
constexpr bool kCounts = true;

// operator new comes here as well.
extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier): the C library calls them so.
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t number, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
// NOLINTEND(bugprone-reserved-identifier)

void* malloc(std::size_t size) {
  countOne();
  return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) {
  countOne();
  return __libc_calloc(number, size);
}
void* realloc(void* memory, std::size_t size) {
  countOne();
  return __libc_realloc(memory, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  countOne();
  return __libc_memalign(alignment, size);
}
}
#endif

namespace suture {

std::uint64_t allocations() { return count; }

bool countsAllocations() { return kCounts; }

NamedThreadAllocations::NamedThreadAllocations(const char* name) {
  countOfNamed = 0;
  wantedName = name;
}

NamedThreadAllocations::~NamedThreadAllocations() { wantedName = nullptr; }

std::uint64_t NamedThreadAllocations::count() const { return countOfNamed; }

}  // namespace suture
