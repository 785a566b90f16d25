// These use the event queue, with several senders, and the doorbell.
#include <suture/rt/doorbell.h>
#include <suture/rt/queue/event_queue.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>

#include "rt/model/scenarios.h"

namespace model {
namespace {

namespace rt = suture::rt;

constexpr std::uint16_t kQueued = 0, kLatest = 1, kLatched = 2;
constexpr rt::EventLimits kEvents[] = {{8, 1, false}, {8, 1, true}};
constexpr rt::EventLimits kWithLatched[] = {
    {8, 1, false}, {8, 1, true}, {.payloadSize = 8, .depth = 1, .latest = false, .latched = true}};

struct Events {
  explicit Events(rt::Producers producers, std::span<const rt::EventLimits> events = kEvents)
      : queue(events, producers) {}

  rt::EventQueue queue;
  std::uint64_t accepted = 0, taken = 0, newest = 0, latched = 0;

  void push(std::uint16_t event, std::uint64_t serial) {
    if (queue.push(event, suture::Time{}, std::as_bytes(std::span(&serial, 1)))) {
      accepted += event == kQueued ? 1 : 0;
    }
  }
  void receive() {
    const rt::EventRecord* record = queue.next();
    if (record == nullptr) return;
    const std::uint16_t event = record->event;
    const std::uint64_t serial = read(record->payload());
    require(read(record->payload()) == serial, "an event is overwritten while it is read");
    taken += event == kQueued ? 1 : 0;
    if (event == kLatest) newest = serial;
    if (event == kLatched) {
      require(serial > latched, "a latched event comes behind a later one");
      latched = serial;
    }
    queue.pop();
  }
};

/// Runs the senders of events, and receives meanwhile.
Run received(const std::shared_ptr<Events>& it, std::vector<std::function<void()>> senders) {
  senders.emplace_back([it] {
    for (int i = 0; i < 3; ++i) it->receive();
  });
  return {.threads = std::move(senders), .atEnd = [it] {
            for (int i = 0; i < 4; ++i) it->receive();
            require(it->taken == it->accepted, "a queued event is lost");
            require(it->newest != 0, "no newest-wins event ever came");
            require(!it->queue.pending(), "the queue does not empty");
          }};
}

}  // namespace

Run eventQueue() {
  const auto it = std::make_shared<Events>(rt::Producers::Any);
  return received(it, {[it] {
                         it->push(kQueued, 1);
                         it->push(kLatest, 2);
                         it->push(kQueued, 3);
                       },
                       [it] {
                         it->push(kLatest, 4);
                         it->push(kLatest, 5);
                       }});
}

Run eventQueueOfTwo() {
  const auto it = std::make_shared<Events>(rt::Producers::Any);
  return received(it, {[it] {
                         it->push(kLatest, 1);
                         it->push(kQueued, 2);
                       },
                       [it] { it->push(kQueued, 3); }});
}

Run eventQueueOfOne() {
  const auto it = std::make_shared<Events>(rt::Producers::One);
  return received(it, {[it] {
                    for (std::uint64_t i = 0; i < 3; ++i) it->push(kQueued, 2 * i);
                    for (std::uint64_t i = 0; i < 3; ++i) it->push(kLatest, 2 * i + 1);
                  }});
}

Run eventQueueLatched() {
  constexpr std::uint64_t kLast = 5;
  const auto it = std::make_shared<Events>(rt::Producers::One, kWithLatched);
  return {.threads = {[it] {
                        for (std::uint64_t i = 1; i <= kLast; ++i) it->push(kLatched, i);
                      },
                      [it] {
                        for (int i = 0; i < 3; ++i) it->receive();
                      }},
          .atEnd = [it] {
            for (std::uint64_t i = 0; i < kLast; ++i) it->receive();
            require(it->latched == kLast, "the last value of a latched event is lost");
            require(it->queue.delivered() + it->queue.dropped() == kLast,
                    "an event was neither heard nor counted");
          }};
}

namespace {

constexpr std::uint32_t kLargeSize = rt::EventRing::kMostShared + 8;
constexpr rt::EventLimits kWithLarge[] = {{kLargeSize, 2, false}, {8, 1, false}};

/// Sends large events among small ones.
struct LargeEvents {
  explicit LargeEvents(rt::Producers producers) : queue(kWithLarge, producers) {}

  rt::EventQueue queue;
  std::uint64_t accepted = 0, taken = 0;

  void push(std::uint64_t serial) {
    std::byte payload[kLargeSize] = {};
    std::memcpy(payload, &serial, sizeof(serial));
    std::memcpy(payload + kLargeSize - sizeof(serial), &serial, sizeof(serial));
    if (queue.push(0, suture::Time{}, payload)) ++accepted;
  }
  void pushSmall(std::uint64_t serial) {
    if (queue.push(1, suture::Time{}, std::as_bytes(std::span(&serial, 1)))) ++accepted;
  }
  void receive() {
    const rt::EventRecord* record = queue.next();
    if (record == nullptr) return;
    const std::byte* const payload = record->payload();
    const std::uint64_t serial = read(payload);
    const std::size_t last = kWithLarge[record->event].payloadSize - sizeof(serial);
    require(read(payload + last) == serial, "an event is torn");
    ++taken;
    queue.pop();
  }
};

}  // namespace

Run eventQueueLarge() {
  const auto it = std::make_shared<LargeEvents>(rt::Producers::Any);
  return {.threads = {[it] { it->push(1); }, [it] { it->push(2); }}, .atEnd = [it] {
            it->receive();
            it->receive();
            it->pushSmall(3);
            it->push(4);  // into a cell that has been given back
            it->receive();
            it->receive();
            require(it->taken == it->accepted, "a queued event is lost");
            require(it->accepted == 4, "an event was dropped though there was room");
            require(!it->queue.pending(), "the queue does not empty");
          }};
}

Run eventQueueLargeOfOne() {
  const auto it = std::make_shared<LargeEvents>(rt::Producers::One);
  return {.threads = {[it] {
                        it->push(1);
                        it->pushSmall(2);
                        for (std::uint64_t i = 3; i < 6; ++i) it->push(i);
                      },
                      [it] {
                        for (int i = 0; i < 4; ++i) it->receive();
                      }},
          .atEnd = [it] {
            for (int i = 0; i < 4; ++i) it->receive();
            require(it->taken == it->accepted, "a queued event is lost");
            require(it->accepted >= 3, "an event was dropped though there was room");
          }};
}

namespace {

/// This is a sleeper that sleeps only if there is nothing to do, beside a thread that brings work
/// and rings.
struct Sleeper {
  Sleeper() : descriptor(eventfd(0, EFD_NONBLOCK)), bell(descriptor) {}
  ~Sleeper() { close(descriptor); }

  bool woken() const {
    std::uint64_t count = 0;
    return ::read(descriptor, &count, sizeof(count)) == sizeof(count);
  }

  int descriptor;
  rt::Doorbell bell;
  std::atomic<int> work{0};
  int done = 0;
  bool asleep = false;
};

}  // namespace

Run doorbellForTwo() {
  struct Rung {
    rt::Doorbell bell;
    rt::RungFor heard = rt::RungFor::Nothing;
  };
  const auto it = std::make_shared<Rung>();
  const auto listen = [it] { it->heard = std::max(it->heard, it->bell.takeRing()); };
  return {.threads = {[it] {
                        for (int i = 0; i < 3; ++i) it->bell.ring(rt::RungFor::Arrival);
                      },
                      [it] { it->bell.ring(rt::RungFor::Work); },
                      [it, listen] {
                        for (int i = 0; i < 3; ++i) {
                          it->bell.prepareToSleep();
                          listen();
                        }
                      }},
          .atEnd = [it, listen] {
            listen();
            require(it->heard == rt::RungFor::Work, "what it was rung for is forgotten");
          }};
}

Run doorbell() {
  const auto it = std::make_shared<Sleeper>();
  return {.threads = {[it] {
                        for (int i = 0; i < 3; ++i) {
                          it->work.fetch_add(1);
                          it->bell.ring();
                        }
                      },
                      [it] {
                        for (int i = 0; i < 5 && !it->asleep; ++i) {
                          it->done += it->work.exchange(0);
                          it->asleep = it->bell.prepareToSleep();
                          if (!it->asleep) it->bell.takeRing();
                        }
                      }},
          .atEnd = [it] {
            require(it->done == 3 || !it->asleep || it->woken(),
                    "it sleeps, there is work, and nobody will ring");
          }};
}

}  // namespace model
