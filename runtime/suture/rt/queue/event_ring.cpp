#include <suture/rt/queue/event_ring.h>

#include <algorithm>
#include <cstring>
#include <new>

namespace suture::rt {
namespace {

std::size_t totalDepth(std::span<const EventLimits> events) {
  std::size_t depth = 1;
  for (const EventLimits& event : events) depth += event.latest ? 0 : event.depth;
  return depth;
}

bool isLarge(const EventLimits& event) {
  return !event.latest && event.payloadSize > EventRing::kMostShared;
}

}  // namespace

std::size_t EventRing::largestShared(std::span<const EventLimits> events) {
  std::size_t size = sizeof(EventRecord);
  for (const EventLimits& event : events) {
    if (event.latest) continue;
    size = std::max(size,
                    isLarge(event) ? sizeof(Reference) : sizeof(EventRecord) + event.payloadSize);
  }
  return size;
}

EventRing::EventRing(std::span<const EventLimits> events, const EventForms& forms,
                     Producers producers, Arena& arena)
    : forms_(forms),
      producers_(producers),
      order_(totalDepth(events), largestShared(events), arena) {
  if (std::none_of(events.begin(), events.end(), isLarge)) return;
  for (const EventLimits& event : events) {
    const std::size_t size = sizeof(EventRecord) + event.payloadSize;
    large_.push_back(isLarge(event) ? std::make_unique<MpscRing>(event.depth, size, arena)
                                    : nullptr);
  }
}

std::byte* EventRing::claimIn(MpscRing& ring) const {
  return producers_ == Producers::One ? ring.claimAlone() : ring.claim();
}

bool EventRing::push(const EventRecord& record, std::span<const std::byte> payload) {
  if (MpscRing* const cells = cellsOf(record.event)) return pushLarge(*cells, record, payload);
  std::byte* const memory = claimIn(order_);
  if (memory == nullptr) return false;
  forms_.write(memory, record, payload);
  order_.commit(memory);
  return true;
}

bool EventRing::pushLarge(MpscRing& cells, const EventRecord& record,
                          std::span<const std::byte> payload) {
  std::byte* const memory = claimIn(cells);
  if (memory == nullptr) return false;
  forms_.write(memory, record, payload);
  return publish(cells, record, memory);
}

// Claims the place in the order last, so that no other producer's event waits for a cell to be
// filled.
bool EventRing::publish(MpscRing& cells, const EventRecord& record, std::byte* memory) {
  const std::uint64_t place = cells.placeOf(memory);
  std::byte* const reference = claimIn(order_);
  if (reference == nullptr) return cells.release(place), false;
  new (reference) Reference{record, place};
  order_.commit(reference);
  return true;
}

std::byte* EventRing::lend(std::uint16_t event) const {
  MpscRing* const cells = cellsOf(event);
  std::byte* const memory = cells == nullptr ? nullptr : claimIn(*cells);
  return memory == nullptr ? nullptr : memory + sizeof(EventRecord);
}

bool EventRing::pushLent(const EventRecord& record, std::byte* payload) {
  std::byte* const memory = payload - sizeof(EventRecord);
  new (memory) EventRecord(record);
  return publish(*cellsOf(record.event), record, memory);
}

void EventRing::giveBack(std::uint16_t event, std::byte* payload) {
  MpscRing& cells = *cellsOf(event);
  cells.release(cells.placeOf(payload - sizeof(EventRecord)));
}

// Reads the number of the event once, because it may change. A record that does not belong in the
// ring, such as that of a newest-wins event, is not copied whole.
void EventRing::copyForeign(std::byte* to, const std::byte* from, std::size_t size) const {
  const std::uint16_t event = eventIn(from);
  const bool whole =
      event < forms_.events() && cellsOf(event) == nullptr && forms_.recordSize(event) <= size;
  if (whole) return forms_.copyForeign(to, from, event);
  std::memcpy(to, from, std::min(size, sizeof(Reference)));
  std::memcpy(to + offsetof(EventRecord, event), &event, sizeof(event));
}

const std::byte* EventRing::first() {
  return order_.front([this](std::byte* to, const std::byte* from, std::size_t size) {
    copyForeign(to, from, size);
  });
}

EventRecord* EventRing::front() {
  const std::byte* memory = first();
  if (memory == nullptr) return nullptr;
  const std::uint16_t event = eventIn(memory);
  if (MpscRing* const cells = cellsOf(event)) {
    const auto& reference = *reinterpret_cast<const Reference*>(memory);
    memory = cells->at(reference.place, [&](std::byte* to, const std::byte* from, std::size_t) {
      forms_.copyForeign(to, from, event);
    });
  }
  return reinterpret_cast<EventRecord*>(const_cast<std::byte*>(memory));
}

void EventRing::pop() {
  const std::byte* const memory = first();
  if (MpscRing* const cells = cellsOf(eventIn(memory))) {
    cells->release(reinterpret_cast<const Reference*>(memory)->place);
  }
  order_.pop();
}

}  // namespace suture::rt
