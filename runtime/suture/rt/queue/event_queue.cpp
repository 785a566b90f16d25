#include <suture/base/slots/shared_slot.h>
#include <suture/rt/counter.h>
#include <suture/rt/queue/event_queue.h>

#include <algorithm>
#include <cstring>
#include <new>

namespace suture::rt {
namespace {

std::size_t totalDepth(std::span<const EventLimits> events) {
  std::size_t depth = 1;
  for (const auto& event : events) depth += event.latest ? 0 : event.depth;
  return depth;
}

std::size_t largestRecord(std::span<const EventLimits> events) {
  std::size_t size = 0;
  for (const auto& event : events) size = std::max<std::size_t>(size, event.payloadSize);
  return sizeof(EventRecord) + size;
}

}  // namespace

EventQueue::EventQueue(std::span<const EventLimits> events, Producers producers, Arena& arena)
    : producers_(producers),
      foreign_(arena.foreign()),
      ring_(totalDepth(events), largestRecord(events), arena),
      counters_(arena.make<EventCounters>()) {
  for (const auto& event : events) {
    payloads_.push_back({event.payloadSize, event.levels});
    const bool hasCell = event.latest || event.latched;
    cells_.push_back(hasCell ? std::make_unique<Cell>(event, arena) : nullptr);
    const std::uint64_t bit = std::uint64_t{1} << (cells_.size() - 1);
    if (event.shared) shared_ |= bit;
    if (!event.shared && !hasCell) plain_ |= bit;
  }
}

// Releases what is left; in foreign memory, no payload owns memory.
EventQueue::~EventQueue() {
  if (foreign_) return;
  while (next() != nullptr) pop();
  for (const auto& cell : cells_) {
    if (cell == nullptr || !cell->shared) continue;
    cell->values.forEachBuffer(
        [](std::byte* memory) { releaseSharedSlot(memory + sizeof(EventRecord)); });
  }
}

void EventQueue::write(std::byte* memory, const EventRecord& record,
                       std::span<const std::byte> payload) const {
  new (memory) EventRecord(record);
  if (payload.empty()) return;
  copyUsed(memory + sizeof(record), payload.data(), payload.size(), payloads_[record.event].levels);
}

// Looks at its copy of the record only, since the original may change.
void EventQueue::copyForeign(std::byte* to, const std::byte* from, std::size_t size) const {
  EventRecord record;
  std::memcpy(&record, from, sizeof(record));
  std::memcpy(to, &record, sizeof(record));
  if (record.event >= payloads_.size()) return;
  const Payload& payload = payloads_[record.event];
  if (payload.size > size - sizeof(record)) return;
  copyUsed(to + sizeof(record), from + sizeof(record), payload.size, payload.levels);
}

// Two threads that emit it at the same moment have no order: one of them gives way.
bool EventQueue::pushLatest(Cell& cell, const EventRecord& record,
                            std::span<const std::byte> payload) {
  const bool alone = producers_ == Producers::One;
  if (!alone && cell.writing.test_and_set(std::memory_order_acquire)) return false;
  replace(cell, record, payload);
  if (!alone) cell.writing.clear(std::memory_order_release);
  return true;
}

void EventQueue::replace(Cell& cell, const EventRecord& record,
                         std::span<const std::byte> payload) {
  std::byte* const memory = cell.values.claim();
  if (cell.shared) releaseSharedSlot(memory + sizeof(EventRecord));  // of one that was replaced
  write(memory, record, payload);
  const bool replaced = cell.values.commit();
  if (replaced && cell.queued) countDropped();
}

bool EventQueue::enqueue(const EventRecord& record, std::span<const std::byte> payload) {
  std::byte* const memory = producers_ == Producers::One ? ring_.claimAlone() : ring_.claim();
  if (memory == nullptr) return false;
  write(memory, record, payload);
  ring_.commit(memory);
  return true;
}

bool EventQueue::pushSpecial(const EventRecord& record, std::span<const std::byte> payload) {
  SharedSlot* const shared = isShared(record.event) ? sharedSlotIn(payload.data()) : nullptr;
  if (shared != nullptr) shared->retain();
  const bool pushed = enter(record, payload);
  if (!pushed && shared != nullptr) shared->release();
  return pushed;
}

// While the cell has a value that was not taken, a later one may not go ahead of it through the
// ring.
bool EventQueue::enter(const EventRecord& record, std::span<const std::byte> payload) {
  Cell* const cell = cells_[record.event].get();
  if (cell == nullptr) return enqueue(record, payload);
  if (cell->queued && !cell->values.fresh() && enqueue(record, payload)) return true;
  return pushLatest(*cell, record, payload);
}

bool EventQueue::push(std::uint16_t event, Time stamp, std::span<const std::byte> payload) {
  const EventRecord record{stamp, event, {}};
  if (isPlain(event) ? enqueue(record, payload) : pushSpecial(record, payload)) return true;
  countDropped();
  return false;
}

// Looks into the ring once more when it sees a queued event in a cell: what had room was put into
// the ring before that, perhaps since the last look.
const std::byte* EventQueue::takeKept() {
  for (cell_ = 0; cell_ < cells_.size(); ++cell_) {
    Cell* const cell = cells_[cell_].get();
    if (cell == nullptr || !cell->values.fresh()) continue;
    const std::byte* const earlier = cell->queued ? ring_.front(copier()) : nullptr;
    fromRing_ = earlier != nullptr;
    if (fromRing_) return earlier;
    if (cell->values.take(copier())) return cell->values.front();
  }
  return nullptr;
}

EventRecord* EventQueue::oldest() {
  const std::byte* memory = ring_.front(copier());
  fromRing_ = memory != nullptr;
  if (!fromRing_) memory = takeKept();
  return reinterpret_cast<EventRecord*>(const_cast<std::byte*>(memory));
}

// True if the provider could have written it. A cell's payload has room for its own event only.
bool EventQueue::makePossible(EventRecord& record) const {
  record.stamp = std::clamp(record.stamp, Time{}, now());
  if (!fromRing_) return record.event == cell_;
  if (record.event >= cells_.size()) return false;
  const Cell* const cell = cells_[record.event].get();
  return cell == nullptr || cell->queued;
}

const EventRecord* EventQueue::next() {
  next_ = oldest();
  // Skip no more than the ring has room for: the provider may write faster than this reads.
  for (std::size_t left = ring_.cells(); next_ != nullptr && foreign_; --left) {
    if (makePossible(*next_)) break;
    if (fromRing_) ring_.pop();
    next_ = left == 0 ? nullptr : oldest();
  }
  return next_;
}

void EventQueue::pop() {
  if (isShared(next_->event)) releaseSharedSlot(next_->payload());
  if (fromRing_) ring_.pop();
  increment(counters_->delivered);
}

bool EventQueue::pending() const {
  return ring_.pending() || std::any_of(cells_.begin(), cells_.end(), [](const auto& cell) {
           return cell != nullptr && cell->values.fresh();
         });
}

}  // namespace suture::rt
