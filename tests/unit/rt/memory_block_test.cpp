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

namespace suture::rt::memory_blocks {
namespace {

TEST(Arena, CountsWhatABlockHasToHave) {
  Arena asked = Arena::measuring();
  const SpscRing ring(256, 8, asked);
  Arena block(std::make_shared<MemoryBlock>("test", asked.used()), Arena::Content::Zeros);
  const SpscRing other(256, 8, block);
  EXPECT_EQ(block.used(), asked.used());
  EXPECT_THROW(block.take(1), SetupError);
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

TEST(MemoryBlock, OthersMayOnlyReadWhereItSaysSo) {
  const MemoryBlock readable("test", 4096, MemoryBlock::Others::Read);
  EXPECT_THROW(MemoryBlock::open(readable.descriptor(), 4096, MemoryBlock::Others::Write),
               SetupError);
  readable.data()[0] = std::byte{1};
  const auto other = MemoryBlock::open(readable.descriptor(), 4096, MemoryBlock::Others::Read);
  EXPECT_EQ(other->data()[0], std::byte{1});
}

TEST(MemoryBlock, AForeignBlockMustBeSealedAndLarge) {
  const MemoryBlock small("test", 4096);
  EXPECT_THROW(MemoryBlock::open(small.descriptor(), 4097, MemoryBlock::Others::Read), SetupError);
  const int loose = memfd_create("test", MFD_ALLOW_SEALING);
  ASSERT_EQ(ftruncate(loose, 8192), 0);
  EXPECT_THROW(MemoryBlock::open(loose, 4096, MemoryBlock::Others::Read), SetupError);
  close(loose);
  EXPECT_THROW(MemoryBlock::open(0, 1, MemoryBlock::Others::Read), SetupError);
}

}  // namespace
}  // namespace suture::rt::memory_blocks
