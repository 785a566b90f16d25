#pragma once
// The queued events on their way from a provider to one subscriber, in the order in which they were
// sent.

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

/// One consumer thread. No allocation after construction, no locks. Each event takes up what itself
/// may need: a large one lies in a cell of its event's own, of which there are as many as its
/// depth, and the ring that all share has only its place.
///
/// In foreign memory each process has an object of its own and uses one end. What front() returns
/// is a copy then, of which any part may be wrong.
class EventRing {
 public:
  /// A larger payload has cells of its own.
  static constexpr std::uint32_t kMostShared = 512;

  /// `forms` are of the same events, and outlive this.
  EventRing(std::span<const EventLimits> events, const EventForms& forms, Producers producers,
            Arena& arena);

  /// Returns how many may wait.
  std::size_t records() const { return order_.cells(); }

  /// Producer: false if there is no room.
  bool push(const EventRecord& record, std::span<const std::byte> payload);

  /// Consumer: the oldest record, or nullptr. Stays valid until pop(). In foreign memory its event
  /// may be none.
  EventRecord* front();
  void pop();
  bool pending() const { return order_.pending(); }

 private:
  // Stands in the shared ring for a record in a cell of its event's own.
  struct Reference {
    EventRecord record;  // of which the number of the event counts
    std::uint64_t place;
  };

  static std::size_t largestShared(std::span<const EventLimits> events);
  MpscRing* cellsOf(std::uint16_t event) const {
    return event < large_.size() ? large_[event].get() : nullptr;
  }
  std::byte* claimIn(MpscRing& ring) const;
  bool pushLarge(MpscRing& cells, const EventRecord& record, std::span<const std::byte> payload);
  void copyForeign(std::byte* to, const std::byte* from, std::size_t size) const;
  const std::byte* first();

  const EventForms& forms_;
  const Producers producers_;
  MpscRing order_;
  std::vector<std::unique_ptr<MpscRing>> large_;  // by event; null: its records lie in order_
};

}  // namespace suture::rt
