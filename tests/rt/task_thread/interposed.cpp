// These stand in for the allocator and the locks of the C library: each call is told to the
// thread's watch. operator new and std::mutex end here. A wait of another kind, say on a condition
// variable, ends in a system call.

#include <dlfcn.h>
#include <pthread.h>

#include <cerrno>
#include <cstddef>

#include "rt/task_thread/watch.h"

extern "C" {

// NOLINTBEGIN(bugprone-reserved-identifier): the C library calls them so.
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);
// NOLINTEND(bugprone-reserved-identifier)

void* malloc(std::size_t size) {
  proof::Watch::noteCall("malloc");
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
  proof::Watch::noteCall("calloc");
  return __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size) {
  proof::Watch::noteCall("realloc");
  return __libc_realloc(memory, size);
}

void* memalign(std::size_t alignment, std::size_t size) {
  proof::Watch::noteCall("memalign");
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
  proof::Watch::noteCall("aligned_alloc");
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  proof::Watch::noteCall("posix_memalign");
  *memory = __libc_memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}

void free(void* memory) {
  if (memory != nullptr) proof::Watch::noteCall("free");
  __libc_free(memory);
}

}  // extern "C"

namespace {

/// Returns the function of this name that the C library has.
template <class Function>
Function* original(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  static const auto lock = original<decltype(pthread_mutex_lock)>("pthread_mutex_lock");
  proof::Watch::noteCall("pthread_mutex_lock");
  return lock(mutex);
}

int pthread_mutex_timedlock(pthread_mutex_t* mutex, const timespec* until) noexcept {
  static const auto lock = original<decltype(pthread_mutex_timedlock)>("pthread_mutex_timedlock");
  proof::Watch::noteCall("pthread_mutex_timedlock");
  return lock(mutex, until);
}

int pthread_mutex_clocklock(pthread_mutex_t* mutex, clockid_t clock,
                            const timespec* until) noexcept {
  static const auto lock = original<decltype(pthread_mutex_clocklock)>("pthread_mutex_clocklock");
  proof::Watch::noteCall("pthread_mutex_clocklock");
  return lock(mutex, clock, until);
}

int pthread_rwlock_rdlock(pthread_rwlock_t* mutex) noexcept {
  static const auto lock = original<decltype(pthread_rwlock_rdlock)>("pthread_rwlock_rdlock");
  proof::Watch::noteCall("pthread_rwlock_rdlock");
  return lock(mutex);
}

int pthread_rwlock_wrlock(pthread_rwlock_t* mutex) noexcept {
  static const auto lock = original<decltype(pthread_rwlock_wrlock)>("pthread_rwlock_wrlock");
  proof::Watch::noteCall("pthread_rwlock_wrlock");
  return lock(mutex);
}

int pthread_spin_lock(pthread_spinlock_t* mutex) noexcept {
  static const auto lock = original<decltype(pthread_spin_lock)>("pthread_spin_lock");
  proof::Watch::noteCall("pthread_spin_lock");
  return lock(mutex);
}

}  // extern "C"
