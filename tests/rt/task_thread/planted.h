#pragma once
// These do on purpose what a component must not do in its cycle. Each names itself in the findings.

#include <atomic>
#include <cstddef>
#include <mutex>
#include <thread>

namespace planted {

[[gnu::noinline]] void allocateAndFree();
[[gnu::noinline]] void askTheKernel();

/// A BusyLock is a lock that another thread holds until a thread has waited for it.
class BusyLock {
 public:
  BusyLock();
  ~BusyLock();
  [[gnu::noinline]] void lockAndUnlock();

 private:
  void hold();

  std::mutex mutex_;
  std::atomic<bool> held_{false}, wanted_{false}, stopping_{false};
  std::thread holder_;
};

/// A FreshMemory is memory that no thread has touched yet.
class FreshMemory {
 public:
  explicit FreshMemory(std::size_t pages);
  ~FreshMemory();
  /// Touches the next page.
  [[gnu::noinline]] void touch();

 private:
  std::size_t size_;
  std::size_t touched_ = 0;
  volatile char* memory_;
};

}  // namespace planted
