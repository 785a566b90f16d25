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

void write(std::byte* memory, const EventRecord& record, std::span<const std::byte> payload) {
  new (memory) EventRecord(record);
  if (!payload.empty()) std::memcpy(memory + sizeof(EventRecord), payload.data(), payload.size());
}

}  // namespace

EventQueue::EventQueue(std::span<const EventLimits> events, Producers producers, Arena& arena)
    : producers_(producers),
      foreign_(arena.foreign()),
      ring_(totalDepth(events), largestRecord(events), arena),
      counters_(arena.make<EventCounters>()) {
  for (const auto& event : events) {
    cells_.push_back(event.latest ? std::make_unique<Cell>(event, arena) : nullptr);
    const std::uint64_t bit = std::uint64_t{1} << (cells_.size() - 1);
    if (event.shared) shared_ |= bit;
    if (!event.shared && !event.latest) plain_ |= bit;
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
  cell.values.commit();
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
  Cell* const cell = cells_[record.event].get();
  const bool pushed =
      cell != nullptr ? pushLatest(*cell, record, payload) : enqueue(record, payload);
  if (!pushed && shared != nullptr) shared->release();
  return pushed;
}

bool EventQueue::push(std::uint16_t event, Time stamp, std::span<const std::byte> payload) {
  const EventRecord record{stamp, event, {}};
  if (isPlain(event) ? enqueue(record, payload) : pushSpecial(record, payload)) return true;
  countDropped();
  return false;
}

EventRecord* EventQueue::oldest() {
  const std::byte* memory = ring_.front();
  fromRing_ = memory != nullptr;
  for (cell_ = 0; memory == nullptr && cell_ < cells_.size(); ++cell_) {
    if (cells_[cell_] != nullptr && cells_[cell_]->values.take()) {
      memory = cells_[cell_]->values.front();
      break;
    }
  }
  return reinterpret_cast<EventRecord*>(const_cast<std::byte*>(memory));
}

// True if the provider could have written it; a cell's payload has room for its own event only.
bool EventQueue::makePossible(EventRecord& record) const {
  record.stamp = std::clamp(record.stamp, Time{}, now());
  if (!fromRing_) return record.event == cell_;
  return record.event < cells_.size() && cells_[record.event] == nullptr;
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
