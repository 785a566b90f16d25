#include <suture/base/slots/shared_slot.h>
#include <suture/rt/counter.h>
#include <suture/rt/queue/event_queue.h>

#include <algorithm>

namespace suture::rt {

EventQueue::EventQueue(std::span<const EventLimits> events, Producers producers, Arena& arena)
    : forms_(events),
      producers_(producers),
      foreign_(arena.foreign()),
      ring_(events, forms_, producers, arena),
      begin_(events.size()),
      counters_(arena.make<EventCounters>()) {
  for (const auto& event : events) {
    const bool hasCell = event.latest || event.latched;
    cells_.push_back(hasCell ? std::make_unique<Cell>(event, arena) : nullptr);
    const std::uint64_t bit = std::uint64_t{1} << (cells_.size() - 1);
    if (event.shared) shared_ |= bit;
    if (!event.shared && !hasCell) plain_ |= bit;
  }
}

// Releases what is left, except in foreign memory, where no payload owns memory.
EventQueue::~EventQueue() {
  if (foreign_) return;
  while (next() != nullptr) pop();
  for (const auto& cell : cells_) {
    if (cell == nullptr || !cell->shared) continue;
    cell->values.forEachBuffer(
        [](std::byte* memory) { releaseSharedSlot(memory + sizeof(EventRecord)); });
  }
}

// If two threads emit the event at the same moment, neither comes first, so one of them gives way.
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
  if (cell.shared) releaseSharedSlot(memory + sizeof(EventRecord));  // a replaced event held it
  forms_.write(memory, record, payload);
  const bool replaced = cell.values.commit();
  if (replaced && cell.queued) countDropped();
}

bool EventQueue::pushSpecial(const EventRecord& record, std::span<const std::byte> payload) {
  SharedSlot* const shared = isShared(record.event) ? sharedSlotIn(payload.data()) : nullptr;
  if (shared != nullptr) shared->retain();
  const bool pushed = enter(record, payload);
  if (!pushed && shared != nullptr) shared->release();
  return pushed;
}

// While the cell has a value that was not taken, a later event may not overtake it through the
// ring.
bool EventQueue::enter(const EventRecord& record, std::span<const std::byte> payload) {
  Cell* const cell = cells_[record.event].get();
  if (cell == nullptr) return ring_.push(record, payload);
  if (cell->queued && !cell->values.fresh() && ring_.push(record, payload)) return true;
  return pushLatest(*cell, record, payload);
}

bool EventQueue::push(std::uint16_t event, Time stamp, std::span<const std::byte> payload) {
  const EventRecord record{stamp, event, {}};
  if (isPlain(event) ? ring_.push(record, payload) : pushSpecial(record, payload)) return true;
  countDropped();
  return false;
}

bool EventQueue::pushLent(std::uint16_t event, Time stamp, std::byte* payload) {
  if (ring_.pushLent({stamp, event, {}}, payload)) return true;
  countDropped();
  return false;
}

bool EventQueue::take(std::size_t cell) {
  return cells_[cell]->values.take([this, cell](std::byte* to, const std::byte* from, std::size_t) {
    forms_.copyForeign(to, from, static_cast<std::uint16_t>(cell));
  });
}

// Looks into the ring once more when it sees a queued event in a cell: events that came before that
// one had room in the ring, perhaps after the last look.
EventRecord* EventQueue::takeKept() {
  for (cell_ = 0; cell_ < cells_.size(); ++cell_) {
    Cell* const cell = cells_[cell_].get();
    if (cell == nullptr || !cell->values.fresh()) continue;
    EventRecord* const earlier = cell->queued ? ring_.front() : nullptr;
    fromRing_ = earlier != nullptr;
    if (fromRing_) return earlier;
    if (!take(cell_)) continue;
    return reinterpret_cast<EventRecord*>(const_cast<std::byte*>(cell->values.front()));
  }
  return nullptr;
}

EventRecord* EventQueue::oldest() {
  EventRecord* const record = ring_.front();
  fromRing_ = record != nullptr;
  return fromRing_ ? record : takeKept();
}

// Bounds the stamp of a record from foreign memory. Returns true if the provider could have written
// the rest.
bool EventQueue::makePossible(EventRecord& record) const {
  record.stamp = std::clamp(record.stamp, Time{}, now());
  if (!fromRing_) return true;
  if (record.event >= cells_.size()) return false;
  const Cell* const cell = cells_[record.event].get();
  return cell == nullptr || cell->queued;
}

const EventRecord* EventQueue::next() {
  next_ = oldest();
  // Skip no more records than the ring has room for, because the provider may write faster than
  // this thread reads.
  for (std::size_t left = ring_.records(); next_ != nullptr && foreign_; --left) {
    if (makePossible(*next_)) break;
    if (fromRing_) ring_.pop();
    next_ = left == 0 ? nullptr : oldest();
  }
  return next_;
}

void EventQueue::pop() {
  if (isShared(next_->event)) releaseSharedSlot(next_->payload());
  if (fromRing_) ring_.pop();
  next_ = nullptr;
  increment(counters_->delivered);
}

// Leaves the value in a cell from which the handler of this event has its own just now: that
// memory must not change, and the value is newer.
void EventQueue::beginAnew(std::uint16_t event) {
  begin_[event] = ring_.end();
  const bool handled = next_ != nullptr && !fromRing_ && cell_ == event;
  if (cells_[event] != nullptr && !handled && take(event)) increment(counters_->delivered);
}

bool EventQueue::fromBefore() const { return fromRing_ && ring_.position() < begin_[next_->event]; }

bool EventQueue::pending() const {
  return ring_.pending() || std::any_of(cells_.begin(), cells_.end(), [](const auto& cell) {
           return cell != nullptr && cell->values.fresh();
         });
}

}  // namespace suture::rt
