#include "rt/task_thread/planted.h"

#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>

namespace planted {
namespace {

constexpr std::size_t kPage = 4096;

}  // namespace

void allocateAndFree() {
  const auto volatile length = std::size_t{100};
  const std::string text(length, 'x');
  if (text.size() != length) throw std::logic_error("not reached");
}

void askTheKernel() { syscall(SYS_getppid); }

BusyLock::BusyLock() : holder_([this] { hold(); }) {}

void BusyLock::hold() {
  const auto aWhile = std::chrono::microseconds(50);
  while (!stopping_) {
    {
      const std::lock_guard lock(mutex_);
      held_ = true;
      while (!wanted_ && !stopping_) std::this_thread::sleep_for(aWhile);
      std::this_thread::sleep_for(2 * aWhile);
      held_ = false;
    }
    std::this_thread::sleep_for(aWhile);
  }
}

BusyLock::~BusyLock() {
  stopping_ = true;
  holder_.join();
}

void BusyLock::lockAndUnlock() {
  while (!held_) {
  }
  wanted_ = true;
  const std::lock_guard lock(mutex_);
  wanted_ = false;
}

FreshMemory::FreshMemory(std::size_t pages) : size_(pages * kPage) {
  void* memory = mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::runtime_error("no memory to touch");
  madvise(memory, size_, MADV_NOHUGEPAGE);  // or the first touch brings 512 pages
  memory_ = static_cast<volatile char*>(memory);
}

FreshMemory::~FreshMemory() { munmap(const_cast<char*>(memory_), size_); }

void FreshMemory::touch() {
  memory_[touched_ % size_] = 1;
  touched_ += kPage;
}

}  // namespace planted
