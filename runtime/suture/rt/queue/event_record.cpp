#include <suture/base/slots/used_parts.h>
#include <suture/rt/queue/event_record.h>
#include <suture/rt/queue/record_copy.h>

#include <cstring>
#include <new>

namespace suture::rt {

void EventForms::write(std::byte* memory, const EventRecord& record,
                       std::span<const std::byte> payload) const {
  new (memory) EventRecord(record);
  if (payload.empty()) return;
  copyUsed(memory + sizeof(record), payload.data(), payload.size(), events_[record.event].levels);
}

void EventForms::copyForeign(std::byte* to, const std::byte* from, std::uint16_t event) const {
  auto record = copyHead<EventRecord>(to, from, sizeof(EventRecord));
  record.event = event;
  std::memcpy(to, &record, sizeof(record));
  const EventLimits& limits = events_[event];
  copyUsed(to + sizeof(record), from + sizeof(record), limits.payloadSize, limits.levels);
}

std::uint16_t eventIn(const std::byte* record) {
  std::uint16_t event;
  std::memcpy(&event, record + offsetof(EventRecord, event), sizeof(event));
  return event;
}

}  // namespace suture::rt
