#include <gtest/gtest.h>
#include <suture/rt/queue/latest_cell.h>
#include <suture/rt/queue/mpsc_ring.h>
#include <suture/rt/queue/spsc_ring.h>

#include <cstring>
#include <deque>
#include <random>
#include <thread>
#include <vector>

namespace suture::rt {
namespace {

void writeNumber(std::byte* memory, std::uint64_t number) {
  std::memcpy(memory, &number, sizeof(number));
}

std::uint64_t readNumber(const std::byte* memory) {
  std::uint64_t number;
  std::memcpy(&number, memory, sizeof(number));
  return number;
}

TEST(SpscRing, HoldsAllThatWasPromised) {
  SpscRing ring(10 * SpscRing::recordSize(40), 40);
  int accepted = 0;
  while (ring.claim(40) != nullptr) {
    ring.commit();
    ++accepted;
  }
  EXPECT_GE(accepted, 10);
  EXPECT_NE(ring.front(), nullptr);
  ring.pop();
  EXPECT_NE(ring.claim(40), nullptr);
}

// Wherever the end of the ring falls, and however long the record is that finds no room before it.
void fillAtEachPlace(std::size_t promised, std::size_t largest) {
  SpscRing ring(promised, largest);
  std::mt19937 random(1);
  std::deque<std::size_t> waiting;
  std::size_t used = 0;
  for (int i = 0; i < 100'000; ++i) {
    const std::size_t size = 8 * (1 + random() % (largest / 8));
    while (used + SpscRing::recordSize(size) > promised) {
      ASSERT_NE(ring.front(), nullptr);
      ring.pop();
      used -= SpscRing::recordSize(waiting.front());
      waiting.pop_front();
    }
    ASSERT_NE(ring.claim(size), nullptr) << "record " << i << " of " << promised << " bytes";
    ring.commit();
    waiting.push_back(size);
    used += SpscRing::recordSize(size);
  }
}

TEST(SpscRing, HasThePromisedRoomEverywhere) {
  fillAtEachPlace(176, 72);  // with one of the largest, just a power of two
  fillAtEachPlace(256, 72);  // a power of two by itself
}

TEST(SpscRing, AnAbandonedClaimLeavesNoTrace) {
  SpscRing ring(256, 8);
  ASSERT_NE(ring.claim(8), nullptr);
  EXPECT_EQ(ring.front(), nullptr);
  writeNumber(ring.claim(8), 7);
  ring.commit();
  ASSERT_NE(ring.front(), nullptr);
  EXPECT_EQ(readNumber(ring.front()), 7u);
}

// Records of random sizes over many laps: every byte arrives, in order, also across the end of the
// ring.
TEST(SpscRing, KeepsOrderAndContentBetweenTwoThreads) {
  constexpr std::uint64_t kRecords = 200'000;
  SpscRing ring(2000, 208);
  std::thread producer([&ring] {
    std::mt19937 random(1);
    for (std::uint64_t i = 0; i < kRecords;) {
      const std::size_t size = 8 + random() % 200;
      std::byte* memory = nullptr;
      while ((memory = ring.claim(size)) == nullptr) std::this_thread::yield();
      writeNumber(memory, i);
      std::memset(memory + 8, static_cast<int>(i & 0xff), size - 8);
      ring.commit();
      ++i;
    }
  });
  std::mt19937 random(1);
  for (std::uint64_t i = 0; i < kRecords;) {
    const std::byte* memory = ring.front();
    if (memory == nullptr) {
      std::this_thread::yield();
      continue;
    }
    const std::size_t size = 8 + random() % 200;
    ASSERT_EQ(ring.frontSize(), size);
    ASSERT_EQ(readNumber(memory), i);
    ASSERT_TRUE(size == 8 || memory[size - 1] == static_cast<std::byte>(i & 0xff));
    ring.pop();
    ++i;
  }
  producer.join();
}

TEST(MpscRing, RefusesWhenFullAndRecovers) {
  MpscRing ring(4, 8);
  for (std::uint64_t i = 0; i < 4; ++i) {
    std::byte* cell = ring.claim();
    ASSERT_NE(cell, nullptr);
    writeNumber(cell, i);
    ring.commit(cell);
  }
  EXPECT_EQ(ring.claim(), nullptr);
  EXPECT_EQ(readNumber(ring.front()), 0u);
  ring.pop();
  EXPECT_NE(ring.claim(), nullptr);
}

TEST(MpscRing, EachProducersOrderHolds) {
  constexpr std::uint64_t kEach = 50'000, kProducers = 3;
  MpscRing ring(64, 16);
  std::vector<std::thread> producers;
  for (std::uint64_t producer = 0; producer < kProducers; ++producer) {
    producers.emplace_back([&ring, producer] {
      for (std::uint64_t i = 0; i < kEach;) {
        std::byte* cell = ring.claim();
        if (cell == nullptr) {
          std::this_thread::yield();
          continue;
        }
        writeNumber(cell, producer);
        writeNumber(cell + 8, i++);
        ring.commit(cell);
      }
    });
  }
  std::vector<std::uint64_t> next(kProducers, 0);
  for (std::uint64_t seen = 0; seen < kEach * kProducers;) {
    const std::byte* cell = ring.front();
    if (cell == nullptr) {
      std::this_thread::yield();
      continue;
    }
    ASSERT_EQ(readNumber(cell + 8), next[readNumber(cell)]++);
    ring.pop();
    ++seen;
  }
  for (auto& producer : producers) producer.join();
}

TEST(LatestCell, OnlyTheNewestIsTaken) {
  LatestCell cell(8);
  EXPECT_FALSE(cell.take());
  writeNumber(cell.claim(), 1);
  EXPECT_FALSE(cell.commit());
  writeNumber(cell.claim(), 2);
  EXPECT_TRUE(cell.commit());  // replaced
  ASSERT_TRUE(cell.take());
  EXPECT_EQ(readNumber(cell.front()), 2u);
  EXPECT_FALSE(cell.take());
}

TEST(LatestCell, NeverTornNeverBackwardsBetweenTwoThreads) {
  constexpr std::uint64_t kValues = 500'000;
  LatestCell cell(64);
  std::thread producer([&cell] {
    for (std::uint64_t i = 1; i <= kValues; ++i) {
      std::byte* memory = cell.claim();
      for (std::size_t word = 0; word < 8; ++word) writeNumber(memory + 8 * word, i);
      cell.commit();
    }
  });
  std::uint64_t last = 0;
  while (last < kValues) {
    if (!cell.take()) continue;
    const std::uint64_t first = readNumber(cell.front());
    for (std::size_t word = 1; word < 8; ++word)
      ASSERT_EQ(readNumber(cell.front() + 8 * word), first);
    ASSERT_GT(first, last);
    last = first;
  }
  producer.join();
}

}  // namespace
}  // namespace suture::rt
