#include <suture/rt/event_queue.h>

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

EventQueue::EventQueue(std::span<const EventLimits> events)
    : ring_(totalDepth(events), largestRecord(events)) {
  for (const auto& event : events) {
    cells_.push_back(event.latest ? std::make_unique<Cell>(sizeof(EventRecord) + event.payloadSize)
                                  : nullptr);
  }
}

bool EventQueue::pushLatest(Cell& cell, const EventRecord& record,
                            std::span<const std::byte> payload) {
  if (cell.writing.test_and_set(std::memory_order_acquire)) return false;
  write(cell.values.claim(), record, payload);
  cell.values.commit();
  cell.writing.clear(std::memory_order_release);
  return true;
}

bool EventQueue::push(std::uint16_t event, Time stamp, std::span<const std::byte> payload) {
  const EventRecord record{stamp, event, {}};
  if (cells_[event] != nullptr) {
    if (pushLatest(*cells_[event], record, payload)) return true;
  } else if (std::byte* memory = ring_.claim(); memory != nullptr) {
    write(memory, record, payload);
    ring_.commit(memory);
    return true;
  }
  dropped_.fetch_add(1, std::memory_order_relaxed);
  return false;
}

const EventRecord* EventQueue::next() {
  const std::byte* memory = ring_.front();
  fromRing_ = memory != nullptr;
  for (std::size_t i = 0; memory == nullptr && i < cells_.size(); ++i) {
    if (cells_[i] != nullptr && cells_[i]->values.take()) memory = cells_[i]->values.front();
  }
  return reinterpret_cast<const EventRecord*>(memory);
}

void EventQueue::pop() {
  if (fromRing_) ring_.pop();
  delivered_.store(delivered_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
}

bool EventQueue::pending() const {
  return ring_.front() != nullptr ||
         std::any_of(cells_.begin(), cells_.end(),
                     [](const auto& cell) { return cell != nullptr && cell->values.fresh(); });
}

}  // namespace suture::rt
