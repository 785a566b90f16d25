#pragma once
// These are the queued events on their way from a provider to one subscriber, in the order in which
// they were sent.

#include <suture/rt/queue/event_record.h>
#include <suture/rt/queue/mpsc_ring.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace suture::rt {

/// Says which threads push.
enum class Producers : std::uint8_t {
  One,  ///< one thread at a time, each after the one before: a task's events come from its own
  Any,  ///< any thread, also several at once: a device's
};

/// One consumer thread; `producers` says which threads push. Never locks, and never allocates after
/// construction. Each event takes up only what it may need itself: a large event lies in a cell
/// that only events of its kind use, of which there are as many as its depth, and the ring that all
/// events share holds only the place of that cell.
///
/// In foreign memory each process has an object of its own and uses one end. What front() returns
/// then is a copy, and any part of it may be wrong.
class EventRing {
 public:
  /// A payload of at most this size lies in the shared ring; a larger one has cells of its own.
  static constexpr std::uint32_t kMostShared = 512;

  /// `forms` must be of the same events and must outlive this.
  EventRing(std::span<const EventLimits> events, const EventForms& forms, Producers producers,
            Arena& arena);

  /// Returns how many may wait.
  std::size_t records() const { return order_.cells(); }

  /// The producer. Returns false if there is no room.
  bool push(const EventRecord& record, std::span<const std::byte> payload);

  /// The producer. Returns room for the payload of a large event, which pushLent() sends or
  /// giveBack() gives up; nullptr if there is none, or the event is not large.
  std::byte* lend(std::uint16_t event) const;
  bool pushLent(const EventRecord& record, std::byte* payload);
  void giveBack(std::uint16_t event, std::byte* payload);

  /// The consumer. Returns the oldest record, or nullptr. It stays valid until pop(). In foreign
  /// memory its event may be a number that does not exist.
  EventRecord* front();
  void pop();
  bool pending() const { return order_.pending(); }
  /// The consumer. Returns the position of front(), and the one behind the last record that waits.
  std::uint64_t position() const { return order_.position(); }
  std::uint64_t end() const { return order_.end(); }

 private:
  // Stands in the shared ring for a record that lies in a cell of its event's own.
  struct Reference {
    EventRecord record;  // only its number of the event is used
    std::uint64_t place;
  };

  static std::size_t largestShared(std::span<const EventLimits> events);
  MpscRing* cellsOf(std::uint16_t event) const {
    return event < large_.size() ? large_[event].get() : nullptr;
  }
  std::byte* claimIn(MpscRing& ring) const;
  bool pushLarge(MpscRing& cells, const EventRecord& record, std::span<const std::byte> payload);
  bool publish(MpscRing& cells, const EventRecord& record, std::byte* memory);
  void copyForeign(std::byte* to, const std::byte* from, std::size_t size) const;
  const std::byte* first();

  const EventForms& forms_;
  const Producers producers_;
  MpscRing order_;
  std::vector<std::unique_ptr<MpscRing>> large_;  // by event; null: its records lie in order_
};

}  // namespace suture::rt
