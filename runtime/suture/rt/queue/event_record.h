#pragma once
// This is how an event lies in memory on its way to one subscriber.

#include <suture/base/slots/bounded_level.h>
#include <suture/base/time.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace suture::rt {

/// Tells a queue what it must know of each event of a contract.
struct EventLimits {
  std::uint32_t payloadSize;  ///< bytes of its payload's slot
  std::uint32_t depth;        ///< how many may wait
  bool latest;                ///< newest wins
  bool shared = false;        ///< the payload is a counted pointer, see base/slots/shared_slot.h
  bool latched = false;       ///< the last value is kept when the queue is full
  BoundedLevels levels = {};  ///< those of the payload's slot
};

/// Precedes the payload of every event.
struct EventRecord {
  Time stamp;  ///< when it was emitted, on this process's clock
  std::uint16_t event;
  std::uint16_t reserved[3];

  std::byte* payload() { return reinterpret_cast<std::byte*>(this + 1); }
  const std::byte* payload() const { return reinterpret_cast<const std::byte*>(this + 1); }
  /// Returns the record that `payload` belongs to.
  static const EventRecord& of(const std::byte* payload) {
    return *(reinterpret_cast<const EventRecord*>(payload) - 1);
  }
};

/// Any thread. Copies the events of a contract.
class EventForms {
 public:
  explicit EventForms(std::span<const EventLimits> events)
      : events_(events.begin(), events.end()) {}

  std::size_t events() const { return events_.size(); }
  std::size_t recordSize(std::uint16_t event) const {
    return sizeof(EventRecord) + events_[event].payloadSize;
  }

  void write(std::byte* memory, const EventRecord& record,
             std::span<const std::byte> payload) const;

  /// Copies the record of `event` out of foreign memory, where it may be anything.
  void copyForeign(std::byte* to, const std::byte* from, std::uint16_t event) const;

 private:
  std::vector<EventLimits> events_;
};

/// Returns the number of the event of a record in foreign memory, where it may change at any time.
std::uint16_t eventIn(const std::byte* record);

}  // namespace suture::rt
