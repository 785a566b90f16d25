#pragma once
// These copy a slot without what is unused of its lists, texts and matrices.

#include <suture/base/slots/bounded_level.h>
#include <suture/base/words.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>

namespace suture {

/// Names bytes of a slot that are used, one behind the other; none if both are its end.
struct UsedPart {
  std::size_t begin, end;
};

/// Returns the first part at or behind `place`. All that is used in front of it must be in the slot
/// already, since that says how much the next level has.
UsedPart nextUsedPart(const std::byte* slot, std::size_t place, std::size_t size,
                      BoundedLevels levels);

/// Returns the same up to the words that the part begins and ends in, for memory that is copied
/// word by word. `place` begins one, or is `size`.
inline UsedPart nextUsedWords(const std::byte* slot, std::size_t place, std::size_t size,
                              BoundedLevels levels) {
  if (levels.empty()) return {place, size};
  const auto [begin, end] = nextUsedPart(slot, place, size, levels);
  if (begin == size) return {size, size};
  return {wordBefore(begin), std::min(wordBytes(end), size)};
}

/// Copies a slot of `size` bytes, except what is unused. What lies at `from` may change meanwhile:
/// each number is read from the copy.
inline void copyUsed(std::byte* to, const std::byte* from, std::size_t size, BoundedLevels levels) {
  for (std::size_t place = 0; place < size;) {
    const auto [begin, end] =
        levels.empty() ? UsedPart{0, size} : nextUsedPart(to, place, size, levels);
    std::memcpy(to + begin, from + begin, end - begin);
    place = end;
  }
}

/// Returns how many bytes packUsed() writes.
std::size_t usedSize(const std::byte* slot, std::size_t size, BoundedLevels levels);

/// Writes what is used, one part behind the other, to where the slot lies or anywhere in front of
/// it, or to other memory. Nobody else may change the slot meanwhile.
void packUsed(std::byte* to, const std::byte* slot, std::size_t size, BoundedLevels levels);

/// Puts what packUsed() has written back in its place, also as it arrives bit by bit.
class UsedReader {
 public:
  UsedReader(std::byte* slot, std::size_t size, BoundedLevels levels)
      : slot_(slot), size_(size), levels_(levels) {}

  /// Takes as much of `packed` as belongs to the slot, and returns what is left.
  std::span<const std::byte> take(std::span<const std::byte> packed);
  /// True if all of the slot is there.
  bool done() const { return next().begin == size_; }
  /// Returns the place up to which the slot is there, or unused.
  std::size_t place() const { return place_; }

 private:
  UsedPart next() const { return nextUsedPart(slot_, place_, size_, levels_); }

  std::byte* slot_;
  std::size_t size_;
  BoundedLevels levels_;
  std::size_t place_ = 0;
};

}  // namespace suture
