// The parts between threads, driven as fast as they go from all processors. Whatever comes out must
// be one whole thing that went in, in order; of what is queued, all of it.

#include <gtest/gtest.h>
#include <suture/rt/event_queue.h>
#include <suture/rt/latest_cell.h>
#include <suture/rt/mailbox.h>
#include <suture/rt/mpsc_ring.h>
#include <suture/rt/spsc_ring.h>
#include <suture/rt/state_table.h>

#include <array>
#include <atomic>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "rt/stress/payload.h"
#include "rt/stress/two_cores.h"

namespace stress {
namespace {

namespace rt = suture::rt;
using Bytes = std::array<std::byte, 120>;  // a PoseSample's

constexpr std::uint64_t kProducers = 3;

std::span<std::byte> at(std::byte* memory, std::size_t size = sizeof(Bytes)) {
  return {memory, size};
}
std::span<const std::byte> at(const std::byte* memory, std::size_t size = sizeof(Bytes)) {
  return {memory, size};
}

/// Records of many lengths, so that the ring's end falls everywhere.
std::size_t lengthOf(std::uint64_t serial) { return 16 + 8 * (serial % 23); }

TEST(Stress, SpscRing) {
  rt::SpscRing ring(1000);
  const Span span;
  std::atomic<bool> ended{false};
  std::uint64_t sent = 0;
  Faults faults;
  runAcrossProcessors({[&] {
                         while (!span.over()) {
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

/// Bodies of kProducers threads that call `send(producer, serial)` until `span` is over, or it
/// returns false at a full queue and is asked again. `ended` counts those that have stopped.
std::vector<std::function<void()>> producers(
    const Span& span, std::vector<std::uint64_t>& sent, std::atomic<std::uint64_t>& ended,
    const std::function<bool(std::uint64_t, std::uint64_t)>& send) {
  std::vector<std::function<void()>> bodies;
  for (std::uint64_t producer = 0; producer < kProducers; ++producer) {
    bodies.emplace_back([&, producer] {
      std::uint64_t serial = 0;
      while (!span.over()) {
        if (send(producer, serial + 1)) {
          ++serial;
        } else {
          std::this_thread::yield();
        }
      }
      sent[producer] = serial;
      ++ended;
    });
  }
  return bodies;
}

/// Which producer sent `serial` as its how-manieth.
std::uint64_t tagged(std::uint64_t producer, std::uint64_t serial) {
  return serial * kProducers + producer;
}

TEST(Stress, MpscRing) {
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

TEST(Stress, LatestCell) {
  rt::LatestCell cell(sizeof(Bytes));
  const Span span;
  std::atomic<std::uint64_t> sent{0};
  Faults faults;
  std::uint64_t lastTaken = 0;
  runAcrossProcessors({[&] {
                         std::uint64_t serial = 0;
                         while (!span.over()) {
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

// Two newest-wins commands and two queued ones, one of them deep: the law of the mailbox is that
// what runs, runs in the order of sending.
TEST(Stress, Mailbox) {
  constexpr rt::CommandLimits kCommands[] = {{sizeof(Bytes), 2, true},
                                             {sizeof(Bytes), 2, true},
                                             {sizeof(Bytes), 3, false},
                                             {sizeof(Bytes), 64, false}};
  rt::Mailbox mailbox(kCommands);
  const Span span;
  std::atomic<bool> ended{false};
  std::array<std::uint64_t, 4> lastSent{}, lastRun{};
  std::uint64_t queuedSent = 0, queuedRun = 0;
  Faults faults;
  const auto produce = [&] {
    for (std::uint64_t serial = 1; !span.over();) {
      const auto command = static_cast<std::uint16_t>((serial * 2654435761u >> 7) % 4);
      const auto memory = mailbox.claim(command, suture::now(), 0);
      if (!memory) {
        std::this_thread::yield();
        continue;
      }
      fill(at(*memory), serial);
      mailbox.commit();
      queuedSent += kCommands[command].latest ? 0 : 1;
      lastSent[command] = serial++;
    }
    ended = true;
  };
  const auto consume = [&] {
    for (bool last = false; !last;) {
      last = ended;
      mailbox.fixCut();
      while (const rt::CommandRecord* record = mailbox.next()) {
        const std::uint16_t command = record->command;
        lastRun[command] = faults.take(serialOf(at(record->arguments())));
        if (faults.hopeless()) return;
        mailbox.pop();
        if (kCommands[command].latest) continue;
        ++queuedRun;
        mailbox.returnCredit(command);
      }
      std::this_thread::yield();
    }
  };
  runAcrossProcessors({produce, consume});
  expectNone(faults, "commands");
  EXPECT_EQ(queuedRun, queuedSent);
  EXPECT_EQ(lastRun, lastSent);
  EXPECT_EQ(mailbox.counters.superseded, 0u);
}

// A queued event and a newest-wins one from each of several threads, as a device's may come. Of two
// newest-wins events at the same moment either may be lost.
TEST(Stress, EventQueue) {
  constexpr rt::EventLimits kEvents[] = {{sizeof(Bytes), 16, false}, {sizeof(Bytes), 1, true}};
  rt::EventQueue queue(kEvents);
  const Span span;
  std::vector<std::uint64_t> sent(kProducers);
  std::atomic<std::uint64_t> ended{0};
  std::vector<Faults> faults(kProducers);
  Faults newest;
  auto bodies = producers(span, sent, ended, [&](std::uint64_t producer, std::uint64_t serial) {
    Bytes bytes;
    fill(bytes, tagged(producer, serial));
    queue.push(1, suture::now(), bytes);
    return queue.push(0, suture::now(), bytes);
  });
  bodies.emplace_back([&] {
    for (bool last = false; !last;) {
      last = ended == kProducers;
      while (const rt::EventRecord* record = queue.next()) {
        const std::uint64_t serial = serialOf(at(record->payload()));
        if (record->event == 1) {
          newest.torn += serial == 0 ? 1 : 0;
          ++newest.seen;
        } else {
          faults[serial % kProducers].take(serial);
        }
        if (faults[0].hopeless() || newest.hopeless()) return;
        queue.pop();
      }
      std::this_thread::yield();
    }
  });
  runAcrossProcessors(bodies);
  for (std::uint64_t producer = 0; producer < kProducers; ++producer) {
    expectNone(faults[producer], "producer " + std::to_string(producer));
    EXPECT_EQ(faults[producer].seen, sent[producer]);
  }
  expectNone(newest, "newest-wins events");
}

// The fewer rows, the sooner a writer catches a reader at it.
TEST(Stress, StateTable) {
  constexpr std::uint32_t kColumns[] = {sizeof(Bytes), sizeof(Bytes)};
  rt::StateTable table(kColumns, 4);
  const Span span;
  std::atomic<bool> ended{false};
  std::vector<Faults> faults(2);
  std::uint64_t apart = 0;  // rows whose columns are not theirs
  const auto write = [&] {
    for (std::uint64_t serial = 1; !span.over(); ++serial) {
      for (unsigned column : {0u, 1u}) fill(at(table.draft(column)), serial);
      table.publish(suture::now(), 3, 0);
    }
    ended = true;
  };
  const auto readColumn = [&] {
    Bytes bytes{};
    std::uint64_t before = 0;
    while (!ended) {
      if (!table.read(1, bytes.data())) continue;
      const std::uint64_t serial = serialOf(bytes);
      if (serial != before) faults[0].take(serial);
      before = serial;
    }
  };
  const auto readRow = [&] {
    Bytes first{}, second{};
    std::byte* const slots[] = {first.data(), second.data()};
    std::uint64_t before = 0;
    while (!ended) {
      const auto row = table.readRow(slots);
      if (row.sequence == before || row.valid != 3) continue;
      before = row.sequence;
      const bool whole =
          faults[1].take(serialOf(first)) == row.sequence && serialOf(second) == row.sequence;
      apart += whole ? 0 : 1;
    }
  };
  runAcrossProcessors({write, readColumn, readRow});
  expectNone(faults[0], "columns");
  expectNone(faults[1], "rows");
  EXPECT_EQ(apart, 0u);
}

// A table of one row without its sequence: what the sums are for.
TEST(Stress, FindsATornPayload) {
  std::array<std::atomic<std::uint64_t>, sizeof(Bytes) / 8> shared{};
  std::atomic<bool> ended{false};
  const suture::Time end = suture::now() + std::chrono::seconds(30);
  Faults faults;
  runAcrossProcessors({[&] {
                         Bytes bytes;
                         for (std::uint64_t serial = 1; !ended; ++serial) {
                           fill(bytes, serial);
                           for (std::size_t i = 0; i < shared.size(); ++i) {
                             std::uint64_t word;
                             std::memcpy(&word, bytes.data() + 8 * i, 8);
                             shared[i].store(word, std::memory_order_release);
                           }
                         }
                       },
                       [&] {
                         Bytes bytes;
                         while (faults.torn == 0 && suture::now() < end) {
                           for (std::size_t i = 0; i < shared.size(); ++i) {
                             const std::uint64_t word = shared[i].load(std::memory_order_acquire);
                             std::memcpy(bytes.data() + 8 * i, &word, 8);
                           }
                           faults.take(serialOf(bytes));
                         }
                         ended = true;
                       }});
  EXPECT_GT(faults.torn, 0u);
}

}  // namespace
}  // namespace stress
