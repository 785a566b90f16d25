#pragma once
// These are the events on their way from a provider to one subscriber.

#include <suture/base/time.h>
#include <suture/rt/queue/event_ring.h>
#include <suture/rt/queue/latest_cell.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace suture::rt {

/// Counts the events of one connection; any thread may read.
struct EventCounters {
  std::atomic<std::uint64_t> delivered{0};  // consumer
  std::atomic<std::uint64_t> dropped{0};    // the threads that emit or pass events on
};

/// One consumer thread; `producers` says which threads push. Never locks, and never allocates after
/// construction. A full queue drops the new event and counts it, so a slow subscriber delays
/// nobody. Of a latched event it keeps the last value all the same, because a subscriber that
/// misses it would believe that an older value still holds.
///
/// In memory that processes share, each process has an object of its own and uses one end. The
/// consumer skips records that cannot be events, because the other process may write anything.
class EventQueue {
 public:
  EventQueue(std::span<const EventLimits> events, Producers producers, Arena& arena);
  EventQueue(std::span<const EventLimits> events, Producers producers, Arena&& arena = {})
      : EventQueue(events, producers, arena) {}
  ~EventQueue();
  EventQueue(const EventQueue&) = delete;
  EventQueue& operator=(const EventQueue&) = delete;

  /// A producer. Returns false if the event was dropped. A counted pointer in `payload` is copied,
  /// and its count goes up.
  bool push(std::uint16_t event, Time stamp, std::span<const std::byte> payload);

  /// A producer. Returns room for the payload of an event of more than EventRing::kMostShared bytes
  /// that has no newest value to keep; pushLent() sends it, giveBack() gives it up. Returns nullptr
  /// if there is no room, or the event is another.
  std::byte* lend(std::uint16_t event) const {
    return isPlain(event) ? ring_.lend(event) : nullptr;
  }
  /// Returns false if the event was dropped.
  bool pushLent(std::uint16_t event, Time stamp, std::byte* payload);
  void giveBack(std::uint16_t event, std::byte* payload) { ring_.giveBack(event, payload); }

  /// The consumer. Returns the oldest queued event, then the newest of each latest() event and of
  /// each latched one that found the queue full; nullptr if none is left. Each event that it
  /// returns must be followed by pop().
  const EventRecord* next();
  void pop();
  /// The consumer, when a subscriber of `event` begins: it is to hear no event that waits already.
  /// next() still returns those in the queue, since a NextEvent may await one, but says by
  /// fromBefore() that they are earlier.
  void beginAnew(std::uint16_t event);
  /// The consumer. Returns true if what next() returned waited already at beginAnew().
  bool fromBefore() const;
  /// The consumer. Returns true if next() would return something.
  bool pending() const;

  /// Returns how many events may wait.
  std::size_t capacity() const { return ring_.records() + cells_.size(); }

  /// Any thread. Counts one more event that was lost behind this queue.
  void countDropped() { counters_->dropped.fetch_add(1, std::memory_order_relaxed); }

  std::uint64_t delivered() const { return counters_->delivered.load(std::memory_order_relaxed); }
  std::uint64_t dropped() const { return counters_->dropped.load(std::memory_order_relaxed); }
  std::shared_ptr<const EventCounters> sharedCounters() const { return counters_; }

 private:
  // Holds the newest value of a newest-wins event, or of a latched one that found the queue full.
  struct Cell {
    Cell(const EventLimits& event, Arena& arena)
        : values(sizeof(EventRecord) + event.payloadSize, arena),
          shared(event.shared),
          queued(!event.latest) {}
    LatestCell values;
    const bool shared;
    const bool queued;  // it goes through the ring as long as there is room
    std::atomic_flag writing = ATOMIC_FLAG_INIT;
  };

  bool isShared(std::uint16_t event) const { return (shared_ >> event & 1) != 0; }
  bool isPlain(std::uint16_t event) const { return (plain_ >> event & 1) != 0; }
  bool pushSpecial(const EventRecord& record, std::span<const std::byte> payload);
  bool enter(const EventRecord& record, std::span<const std::byte> payload);
  bool pushLatest(Cell& cell, const EventRecord& record, std::span<const std::byte> payload);
  void replace(Cell& cell, const EventRecord& record, std::span<const std::byte> payload);
  EventRecord* oldest();
  EventRecord* takeKept();
  bool take(std::size_t cell);
  bool makePossible(EventRecord& record) const;

  const EventForms forms_;
  const Producers producers_;
  std::vector<std::unique_ptr<Cell>> cells_;  // by event; null: only queued
  // These have one bit for each event: a contract has at most 64.
  std::uint64_t shared_ = 0;
  std::uint64_t plain_ = 0;  // neither shared nor with a cell; the sender tests only this bit
  const bool foreign_;
  EventRing ring_;
  EventRecord* next_ = nullptr;  // what the last next() returned
  bool fromRing_ = false;
  std::size_t cell_ = 0;              // if it is not from the ring
  std::vector<std::uint64_t> begin_;  // by event: the end of the ring at its last beginAnew()
  const std::shared_ptr<EventCounters> counters_;
};

}  // namespace suture::rt
