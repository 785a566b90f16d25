// This is memory that processes share, and what is laid out in it.
#include <gtest/gtest.h>
#include <suture/base/arena.h>
#include <suture/base/errors.h>
#include <suture/rt/queue/mpsc_ring.h>
#include <suture/rt/queue/spsc_ring.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <memory>

#include "support/contains.h"
#include "support/refusal.h"

namespace suture::rt::memory_blocks {
namespace {

TEST(Arena, CountsWhatABlockHasToHave) {
  Arena asked = Arena::measuring();
  const SpscRing ring(256, 8, asked);
  Arena block(std::make_shared<MemoryBlock>("test", asked.used()), Arena::Content::Zeros);
  const SpscRing other(256, 8, block);
  EXPECT_EQ(block.used(), asked.used());
  EXPECT_TRUE(contains(refusal([&] { block.take(1); }), "bytes: it is too small. Build both"));
}

TEST(Arena, MeasuresWithoutTouchingWhatItMeasures) {
  constexpr std::size_t kCells = 1 << 14;
  const auto faults = [] {
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return usage.ru_minflt;
  };
  const auto before = faults();
  Arena asked = Arena::measuring();
  const MpscRing cells(kCells, 1024, asked);
  EXPECT_GT(asked.used(), kCells * 1024);
  EXPECT_LT(faults() - before, 100);  // it has 4,096 pages at least
}

TEST(MemoryBlock, OthersMayOnlyRead) {
  const MemoryBlock readable("test", 4096, MemoryBlock::Others::Read);
  EXPECT_THROW(MemoryBlock::open(readable.descriptor(), 4096, MemoryBlock::Others::Write),
               SetupError);
  readable.data()[0] = std::byte{1};
  const auto other = MemoryBlock::open(readable.descriptor(), 4096, MemoryBlock::Others::Read);
  EXPECT_EQ(other->data()[0], std::byte{1});
}

TEST(MemoryBlock, AForeignBlockMustBeSealed) {
  const MemoryBlock small("test", 4096);
  const auto refused = [](int descriptor, std::size_t size) {
    return refusal([&] { MemoryBlock::open(descriptor, size, MemoryBlock::Others::Read); });
  };
  EXPECT_EQ(refused(small.descriptor(), 4097),
            "use the memory block of another process: it has 4096 bytes of 4097. Build both "
            "processes from the same release");
  const int loose = memfd_create("test", MFD_ALLOW_SEALING);
  ASSERT_EQ(ftruncate(loose, 8192), 0);
  EXPECT_TRUE(contains(refused(loose, 4096), "it may shrink"));
  close(loose);
  EXPECT_TRUE(contains(refused(0, 1), "it is no sealed memory"));
}

TEST(MemoryBlock, AKernelsDenialIsNamed) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit none{0, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
  const std::string error = refusal([] { MemoryBlock("rows", 4096); });
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_TRUE(contains(error, "cannot make the memory block 'rows' of 4096 bytes: ")) << error;
  EXPECT_TRUE(contains(error, ": Too many open files. Check the limits on memory and open files"))
      << error;
}

}  // namespace
}  // namespace suture::rt::memory_blocks
