// These are rings and cells between two processes.
#include <suture/rt/queue/latest_cell.h>
#include <suture/rt/queue/mpsc_ring.h>
#include <suture/rt/queue/spsc_ring.h>

#include <algorithm>
#include <vector>

#include "foreign_queue.h"

namespace suture::rt::foreign_rings {
namespace {

using foreign_memory::Shared;
using foreign_memory::survivesAnything;

void put(SpscRing& ring, std::uint64_t value) {
  std::byte* const memory = ring.claim(sizeof(value));
  ASSERT_NE(memory, nullptr);
  std::memcpy(memory, &value, sizeof(value));
  ring.commit();
}

std::uint64_t valueAt(const std::byte* memory) {
  std::uint64_t value;
  std::memcpy(&value, memory, sizeof(value));
  return value;
}

TEST(ForeignSpscRing, CarriesRecordsRoundAndRound) {
  Shared<SpscRing> ring(std::size_t{100}, std::size_t{8});
  for (std::uint64_t i = 0; i < 1000; ++i) {
    put(*ring.producer, i);
    const std::byte* const front = ring.consumer->front();
    ASSERT_NE(front, nullptr);
    EXPECT_EQ(front, ring.consumer->front());  // until pop()
    EXPECT_EQ(valueAt(front), i);
    EXPECT_EQ(ring.consumer->frontSize(), sizeof(i));
    ring.consumer->pop();
    EXPECT_EQ(ring.consumer->front(), nullptr);
  }
}

TEST(ForeignSpscRing, AFrontIsACopy) {
  Shared<SpscRing> ring(std::size_t{100}, std::size_t{8});
  put(*ring.producer, 7);
  const std::byte* const front = ring.consumer->front();
  std::ranges::fill(ring.bytes(), std::byte{0xff});
  EXPECT_EQ(valueAt(front), 7u);
  ring.consumer->pop();
}

TEST(ForeignSpscRing, AProducerTrustsOnlyItsOwnPositions) {
  Shared<SpscRing> ring(std::size_t{100}, std::size_t{8});
  put(*ring.producer, 1);
  std::ranges::fill(ring.bytes().first(128), std::byte{0xee});  // both positions
  for (int i = 0; i < 100; ++i) {
    std::byte* const memory = ring.producer->claim(8);
    if (memory == nullptr) break;
    EXPECT_GE(memory, ring.block->data());
    EXPECT_LE(memory + 8, ring.block->data() + ring.used);
    ring.producer->commit();
  }
}

TEST(ForeignSpscRing, SurvivesWhateverItsMemoryHolds) {
  survivesAnything<SpscRing>(
      [](Shared<SpscRing>& ring, const auto& scramble) {
        for (std::uint64_t i = 0; i < 5; ++i) put(*ring.producer, i);
        scramble();
        for (int i = 0; i < 100; ++i) {
          const std::byte* const front = ring.consumer->front();
          if (front == nullptr) break;
          EXPECT_LE(ring.consumer->frontSize(), 8u);
          std::vector<std::byte> copy(front, front + ring.consumer->frontSize());
          ring.consumer->pop();
        }
      },
      std::size_t{200}, std::size_t{8});
}

TEST(ForeignMpscRing, SurvivesWhateverItsMemoryHolds) {
  survivesAnything<MpscRing>(
      [](Shared<MpscRing>& ring, const auto& scramble) {
        for (int i = 0; i < 3; ++i) ring.producer->commit(ring.producer->claim());
        scramble();
        for (int i = 0; i < 20; ++i) {
          if (std::byte* const cell = ring.producer->claim()) ring.producer->commit(cell);
          if (ring.consumer->front() != nullptr) ring.consumer->pop();
        }
      },
      std::size_t{8}, std::size_t{24});
}

TEST(ForeignLatestCell, SurvivesWhateverItsMemoryHolds) {
  survivesAnything<LatestCell>(
      [](Shared<LatestCell>& cell, const auto& scramble) {
        for (int i = 0; i < 10; ++i) {
          std::memset(cell.producer->claim(), i, 40);
          cell.producer->commit();
          scramble();
          if (cell.consumer->take()) {
            std::vector<std::byte> copy(cell.consumer->front(), cell.consumer->front() + 40);
          }
        }
      },
      std::size_t{40});
}

}  // namespace
}  // namespace suture::rt::foreign_rings
