// Mailbox and event queue are under the same stress as the rings that they are made of.

#include <gtest/gtest.h>
#include <suture/rt/queue/event_queue.h>
#include <suture/rt/queue/mailbox.h>

#include <array>
#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "rt/stress/payload.h"
#include "rt/stress/two_cores.h"

namespace stress {
namespace {

namespace rt = suture::rt;

// Two newest-wins commands and two queued ones, one of them deep: the law of the mailbox is that
// what runs, runs in the order of sending.
TEST(Stress, AMailboxRunsCommandsInOrder) {
  constexpr rt::CommandLimits kCommands[] = {{sizeof(Bytes), 2, true},
                                             {sizeof(Bytes), 2, true},
                                             {sizeof(Bytes), 3, false},
                                             {sizeof(Bytes), 64, false}};
  rt::Mailbox mailbox(kCommands);
  const Span span;
  std::atomic<bool> ended{false};
  std::array<std::uint64_t, 4> lastSent{}, lastRun{};
  std::uint64_t queuedSent = 0, queuedRun = 0, runs = 0;
  Faults faults;
  const auto produce = [&] {
    for (std::uint64_t serial = 1; !span.over(serial - 1);) {
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
        ++runs;
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
  EXPECT_EQ(runs + mailbox.counters.replaced + mailbox.counters.overtaken, mailbox.counters.sent);
}

// A queued event and a newest-wins one come from each of several threads, as a device's may. Of two
// newest-wins events at the same moment either may be lost.
TEST(Stress, AnEventQueueKeepsEachThreadsOrder) {
  constexpr rt::EventLimits kEvents[] = {{sizeof(Bytes), 16, false}, {sizeof(Bytes), 1, true}};
  rt::EventQueue queue(kEvents, rt::Producers::Any);
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

// The same events come from one thread, as a task's do.
TEST(Stress, EventQueueOfOne) {
  constexpr rt::EventLimits kEvents[] = {{sizeof(Bytes), 16, false}, {sizeof(Bytes), 1, true}};
  rt::EventQueue queue(kEvents, rt::Producers::One);
  const Span span;
  std::atomic<bool> ended{false};
  std::uint64_t sent = 0;
  Faults queued, newest;
  const auto produce = [&] {
    Bytes bytes;
    for (std::uint64_t serial = 1; !span.over(sent); ++serial) {
      fill(bytes, serial);
      queue.push(1, suture::now(), bytes);
      if (queue.push(0, suture::now(), bytes)) {
        ++sent;
      } else {
        std::this_thread::yield();
      }
    }
    ended = true;
  };
  const auto consume = [&] {
    for (bool last = false; !last;) {
      last = ended;
      while (const rt::EventRecord* record = queue.next()) {
        (record->event == 1 ? newest : queued).take(serialOf(at(record->payload())));
        if (queued.hopeless() || newest.hopeless()) return;
        queue.pop();
      }
      std::this_thread::yield();
    }
  };
  runAcrossProcessors({produce, consume});
  expectNone(queued, "queued events");
  expectNone(newest, "newest-wins events");
  EXPECT_EQ(queued.seen, sent);
}

}  // namespace
}  // namespace stress
