// These show that the counter misses nothing, or every other test here would pass for nothing.

#include <gtest/gtest.h>
#include <pthread.h>

#include <cstdlib>
#include <new>
#include <thread>

#include "support/allocations.h"

namespace suture {
namespace {

TEST(Allocations, EveryWayIsCounted) {
  ASSERT_TRUE(countsAllocations());
  const std::uint64_t before = allocations();
  void* volatile memory = ::operator new(8);  // volatile: or the pair is optimised away
  ::operator delete(memory);
  EXPECT_EQ(allocations() - before, 1u);
  memory = std::malloc(8);
  void* volatile larger = std::realloc(memory, 4096);
  std::free(larger);
  memory = std::calloc(2, 8);
  std::free(memory);
  memory = std::aligned_alloc(64, 64);
  std::free(memory);
  EXPECT_EQ(allocations() - before, 5u);
}

TEST(Allocations, AreThoseOfTheCallingThread) {
  std::uint64_t there = 0;
  std::thread other([&] {
    void* volatile memory = ::operator new(8);
    ::operator delete(memory);
    there = allocations();
  });
  other.join();
  EXPECT_GE(there, 1u);
  const std::uint64_t before = allocations();
  EXPECT_EQ(allocations(), before);
}

TEST(Allocations, AreCountedByThreadName) {
  const auto allocateAs = [](const char* name) {
    std::thread([name] {
      pthread_setname_np(pthread_self(), name);
      void* volatile memory = ::operator new(8);
      ::operator delete(memory);
    }).join();
  };
  const NamedThreadAllocations named("some-name");
  allocateAs("another-name");
  EXPECT_EQ(named.count(), 0u);
  allocateAs("some-name");
  allocateAs("some-name");
  EXPECT_EQ(named.count(), 2u);
}

}  // namespace
}  // namespace suture
