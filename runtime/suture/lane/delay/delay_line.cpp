#include <suture/lane/delay/delay_line.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace suture {
namespace {

std::size_t slotsOf(std::size_t slotSize, std::size_t records) {
  constexpr std::size_t kMostBytes = std::size_t{16} << 20;
  return std::max<std::size_t>(std::min(records, kMostBytes / slotSize), 4);
}

}  // namespace

// The constructor touches no page of this memory before it is used.
DelayLine::DelayLine(std::size_t largest, std::size_t records)
    : slotSize_(wordBytes(std::max<std::size_t>(largest, 1))),
      memory_(new std::byte[slotsOf(slotSize_, records) * slotSize_]),
      free_(slotsOf(slotSize_, records)) {
  std::iota(free_.rbegin(), free_.rend(), 0u);  // the lowest are used first
  waiting_.reserve(free_.size());
}

bool DelayLine::isLater(const Record& one, const Record& other) {
  return std::tie(one.due, one.number) > std::tie(other.due, other.number);
}

std::byte* DelayLine::claim(Time due, std::size_t size, Order order) {
  if (free_.empty() || size > slotSize_) return nullptr;
  claimedOrder_ = order;
  claimed_ = {.due = order == Order::Kept ? std::max(last_, due) : due,
              .number = ++numbered_,
              .size = size,
              .slot = free_.back()};
  return memoryOf(claimed_.slot);
}

void DelayLine::commit() {
  if (claimedOrder_ == Order::Kept) last_ = claimed_.due;
  free_.pop_back();
  waiting_.push_back(claimed_);
  std::push_heap(waiting_.begin(), waiting_.end(), isLater);
}

const std::byte* DelayLine::due(Time now) const {
  return next() <= now ? memoryOf(waiting_.front().slot) : nullptr;
}

void DelayLine::pop() {
  std::pop_heap(waiting_.begin(), waiting_.end(), isLater);
  free_.push_back(waiting_.back().slot);
  waiting_.pop_back();
}

}  // namespace suture
