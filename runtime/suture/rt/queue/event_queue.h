#pragma once
// The events on their way from a provider to one subscriber.

#include <suture/base/slots/bounded_level.h>
#include <suture/base/time.h>
#include <suture/rt/queue/latest_cell.h>
#include <suture/rt/queue/mpsc_ring.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace suture::rt {

/// What the queue must know of each event of a contract.
struct EventLimits {
  std::uint32_t payloadSize;  ///< bytes of its payload's slot
  std::uint32_t depth;        ///< how many may wait
  bool latest;                ///< newest wins
  bool shared = false;        ///< the payload is a counted pointer, see base/slots/shared_slot.h
  bool latched = false;       ///< its last value is kept when the queue is full
  BoundedLevels levels = {};  ///< of the payload
};

/// Precedes the payload of every event.
struct EventRecord {
  Time stamp;  ///< when it was emitted, on this process's clock
  std::uint16_t event;
  std::uint16_t reserved[3];

  std::byte* payload() { return reinterpret_cast<std::byte*>(this + 1); }
  const std::byte* payload() const { return reinterpret_cast<const std::byte*>(this + 1); }
  /// The record that `payload` belongs to.
  static const EventRecord& of(const std::byte* payload) {
    return *(reinterpret_cast<const EventRecord*>(payload) - 1);
  }
};

/// Which threads push into an EventQueue.
enum class Producers : std::uint8_t {
  One,  ///< one thread at a time, each after the one before: a task's events come from its own
  Any,  ///< any thread, also several at once: a device's
};

/// Counts of one connection; any thread may read.
struct EventCounters {
  std::atomic<std::uint64_t> delivered{0};  // consumer
  std::atomic<std::uint64_t> dropped{0};    // those who emit, or pass on
};

/// One consumer thread. No allocation after construction, no locks. A full queue drops the new
/// event and counts it, so a slow subscriber delays nobody. Of a latched event it keeps the last
/// value all the same, since who hears nothing after it takes an older one for what holds.
///
/// In foreign memory each process has an object of its own and uses one end. The consumer skips
/// what cannot be an event.
class EventQueue {
 public:
  EventQueue(std::span<const EventLimits> events, Producers producers, Arena& arena);
  EventQueue(std::span<const EventLimits> events, Producers producers, Arena&& arena = {})
      : EventQueue(events, producers, arena) {}
  ~EventQueue();
  EventQueue(const EventQueue&) = delete;
  EventQueue& operator=(const EventQueue&) = delete;

  /// False if the event was dropped. A counted pointer in `payload` is copied, and counted.
  bool push(std::uint16_t event, Time stamp, std::span<const std::byte> payload);

  /// Consumer: the oldest queued event, then the newest of each latest() event, and of each latched
  /// one that found the queue full; nullptr: none left.
  /// Must be followed by pop().
  const EventRecord* next();
  void pop();
  /// Consumer: true if next() would return something.
  bool pending() const;

  /// How many may wait.
  std::size_t capacity() const { return ring_.cells() + cells_.size(); }

  /// Any thread: one more event has been lost, behind this queue.
  void countDropped() { counters_->dropped.fetch_add(1, std::memory_order_relaxed); }

  std::uint64_t delivered() const { return counters_->delivered.load(std::memory_order_relaxed); }
  std::uint64_t dropped() const { return counters_->dropped.load(std::memory_order_relaxed); }
  std::shared_ptr<const EventCounters> sharedCounters() const { return counters_; }

 private:
  // A newest-wins event, or what of a latched one has found the queue full.
  struct Cell {
    Cell(const EventLimits& event, Arena& arena)
        : values(sizeof(EventRecord) + event.payloadSize, arena),
          shared(event.shared),
          queued(!event.latest) {}
    LatestCell values;
    const bool shared;
    const bool queued;  // as long as there is room
    std::atomic_flag writing = ATOMIC_FLAG_INIT;
  };

  struct Payload {
    std::uint32_t size;
    BoundedLevels levels;
  };

  bool isShared(std::uint16_t event) const { return (shared_ >> event & 1) != 0; }
  bool isPlain(std::uint16_t event) const { return (plain_ >> event & 1) != 0; }
  void write(std::byte* memory, const EventRecord& record,
             std::span<const std::byte> payload) const;
  /// Copies a record out of foreign memory, unless it cannot be: makePossible() finds that out.
  void copyForeign(std::byte* to, const std::byte* from, std::size_t size) const;
  auto copier() const {
    return [this](std::byte* to, const std::byte* from, std::size_t size) {
      copyForeign(to, from, size);
    };
  }
  bool enqueue(const EventRecord& record, std::span<const std::byte> payload);
  bool pushSpecial(const EventRecord& record, std::span<const std::byte> payload);
  bool enter(const EventRecord& record, std::span<const std::byte> payload);
  bool pushLatest(Cell& cell, const EventRecord& record, std::span<const std::byte> payload);
  void replace(Cell& cell, const EventRecord& record, std::span<const std::byte> payload);
  EventRecord* oldest();
  const std::byte* takeKept();
  bool makePossible(EventRecord& record) const;

  const Producers producers_;
  std::vector<Payload> payloads_;             // by event
  std::vector<std::unique_ptr<Cell>> cells_;  // by event; null: only queued
  // A bit an event: at most 64 in a contract.
  std::uint64_t shared_ = 0;
  std::uint64_t plain_ = 0;  // not special in any way: all that a sender has to look at
  const bool foreign_;
  MpscRing ring_;
  EventRecord* next_ = nullptr;  // what the last next() returned
  bool fromRing_ = false;
  std::size_t cell_ = 0;  // if it is not from the ring
  const std::shared_ptr<EventCounters> counters_;
};

}  // namespace suture::rt
