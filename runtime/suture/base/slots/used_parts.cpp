#include <suture/base/slots/used_parts.h>

#include <algorithm>

namespace suture {

UsedPart nextUsedPart(const std::byte* slot, std::size_t place, std::size_t size,
                      BoundedLevels levels) {
  for (const BoundedLevel& level : levels) {
    if (place < level.data) return {place, level.data};
    const std::size_t end = std::size_t{level.data} + level.mostBytes();
    if (place >= end) continue;
    const std::size_t usedEnd = level.data + level.usedBytes(slot);
    if (place < usedEnd) return {place, usedEnd};
    place = end;
  }
  return {place, size};
}

std::size_t usedSize(const std::byte* slot, std::size_t size, BoundedLevels levels) {
  for (const BoundedLevel& level : levels) size -= level.mostBytes() - level.usedBytes(slot);
  return size;
}

// Reads the size of a level before it moves what is in front of it, which may then overwrite the
// size.
void packUsed(std::byte* to, const std::byte* slot, std::size_t size, BoundedLevels levels) {
  const auto move = [&](std::size_t begin, std::size_t end) {
    std::memmove(to, slot + begin, end - begin);
    to += end - begin;
  };
  std::size_t place = 0;
  for (const BoundedLevel& level : levels) {
    const std::size_t used = level.usedBytes(slot);
    move(place, level.data);
    move(level.data, level.data + used);
    place = level.data + level.mostBytes();
  }
  move(place, size);
}

std::span<const std::byte> UsedReader::take(std::span<const std::byte> packed) {
  while (!packed.empty()) {
    const auto [begin, end] = next();
    if (begin == size_) break;
    const std::size_t part = std::min(end - begin, packed.size());
    std::memcpy(slot_ + begin, packed.data(), part);
    packed = packed.subspan(part);
    place_ = begin + part;
  }
  return packed;
}

}  // namespace suture
