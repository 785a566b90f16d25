// Rings and newest-wins cell are driven as fast as they go from all processors. Each thing that
// comes out is a whole one that went in, in order; of what is queued, all comes out.

#include <gtest/gtest.h>
#include <suture/rt/queue/latest_cell.h>
#include <suture/rt/queue/mpsc_ring.h>
#include <suture/rt/queue/spsc_ring.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "rt/stress/payload.h"
#include "rt/stress/two_cores.h"

namespace stress {
namespace {

namespace rt = suture::rt;

/// Returns one of many lengths of records, so that the ring's end falls everywhere.
std::size_t lengthOf(std::uint64_t serial) { return 16 + 8 * (serial % 23); }

TEST(Stress, AnSpscRingLosesNothing) {
  rt::SpscRing ring(1000, 192);
  const Span span;
  std::atomic<bool> ended{false};
  std::uint64_t sent = 0;
  Faults faults;
  runAcrossProcessors({[&] {
                         while (!span.over(sent)) {
                           const std::size_t length = lengthOf(sent + 1);
                           std::byte* memory = ring.claim(length);
                           if (memory == nullptr) {
                             std::this_thread::yield();
                             continue;
                           }
                           fill(at(memory, length), ++sent);
                           ring.commit();
                         }
                         ended = true;
                       },
                       [&] {
                         for (bool last = false; !last;) {
                           last = ended;
                           while (const std::byte* memory = ring.front()) {
                             faults.take(serialOf(at(memory, ring.frontSize())));
                             if (faults.hopeless()) return;
                             ring.pop();
                           }
                           std::this_thread::yield();
                         }
                       }});
  expectNone(faults, "records");
  EXPECT_EQ(faults.seen, sent);
}

TEST(Stress, AnMpscRingLosesNothing) {
  rt::MpscRing ring(64, sizeof(Bytes));
  const Span span;
  std::vector<std::uint64_t> sent(kProducers);
  std::atomic<std::uint64_t> ended{0};
  std::vector<Faults> faults(kProducers);
  auto bodies = producers(span, sent, ended, [&](std::uint64_t producer, std::uint64_t serial) {
    std::byte* cell = ring.claim();
    if (cell == nullptr) return false;
    fill(at(cell), tagged(producer, serial));
    ring.commit(cell);
    return true;
  });
  bodies.emplace_back([&] {
    for (bool last = false; !last;) {
      last = ended == kProducers;
      while (const std::byte* cell = ring.front()) {
        const std::uint64_t serial = serialOf(at(cell));
        Faults& ofProducer = faults[serial % kProducers];
        ofProducer.take(serial);
        if (ofProducer.hopeless()) return;
        ring.pop();
      }
      std::this_thread::yield();
    }
  });
  runAcrossProcessors(bodies);
  for (std::uint64_t producer = 0; producer < kProducers; ++producer) {
    expectNone(faults[producer], "producer " + std::to_string(producer));
    EXPECT_EQ(faults[producer].seen, sent[producer]);
  }
}

TEST(Stress, ALatestCellNeverGoesBack) {
  rt::LatestCell cell(sizeof(Bytes));
  const Span span;
  std::atomic<std::uint64_t> sent{0};
  Faults faults;
  std::uint64_t lastTaken = 0;
  runAcrossProcessors({[&] {
                         std::uint64_t serial = 0;
                         while (!span.over(serial)) {
                           fill(at(cell.claim()), ++serial);
                           cell.commit();
                         }
                         sent = serial;
                       },
                       [&] {
                         for (bool last = false; !last;) {
                           last = sent != 0;
                           if (cell.take()) lastTaken = faults.take(serialOf(at(cell.front())));
                         }
                       }});
  expectNone(faults, "values");
  EXPECT_EQ(lastTaken, sent);
}

}  // namespace
}  // namespace stress
