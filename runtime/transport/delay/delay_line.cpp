#include <suture/transport/delay/delay_line.h>

#include <algorithm>
#include <new>

namespace suture {
namespace {

std::size_t ringBytes(std::size_t largest, std::size_t records) {
  constexpr std::size_t kMostBytes = std::size_t{16} << 20;
  const std::size_t one = rt::SpscRing::recordSize(sizeof(Time) + largest);
  return std::max(std::min(records * one, kMostBytes), 4 * one);
}

}  // namespace

DelayLine::DelayLine(std::size_t largest, std::size_t records)
    : ring_(ringBytes(largest, records)) {}

std::byte* DelayLine::claim(Time due, std::size_t size) {
  std::byte* memory = ring_.claim(sizeof(Time) + size);
  if (memory == nullptr) return nullptr;
  last_ = std::max(last_, due);  // nothing overtakes
  new (memory) Time(last_);
  return memory + sizeof(Time);
}

Time DelayLine::next() {
  const std::byte* memory = ring_.front();
  return memory == nullptr ? Time::max() : *reinterpret_cast<const Time*>(memory);
}

const std::byte* DelayLine::due(Time now) {
  return next() <= now ? ring_.front() + sizeof(Time) : nullptr;
}

}  // namespace suture
