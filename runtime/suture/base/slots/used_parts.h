#pragma once
// These copy a slot without the unused parts of its lists, texts and matrices.

#include <suture/base/slots/bounded_level.h>
#include <suture/base/words.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>

namespace suture {

/// Names bytes of a slot that are used and contiguous. Both are the end of the slot if there are
/// none.
struct UsedPart {
  std::size_t begin, end;
};

/// Returns the first part at or behind `place`. The slot must hold all used bytes in front of it,
/// because those say how much the next level has.
UsedPart nextUsedPart(const std::byte* slot, std::size_t place, std::size_t size,
                      BoundedLevels levels);

/// Returns the same, extended to whole words, for memory that is copied word by word. `place`
/// begins a word, or is `size`.
inline UsedPart nextUsedWords(const std::byte* slot, std::size_t place, std::size_t size,
                              BoundedLevels levels) {
  if (levels.empty()) return {place, size};
  const auto [begin, end] = nextUsedPart(slot, place, size, levels);
  if (begin == size) return {size, size};
  return {wordBefore(begin), std::min(wordBytes(end), size)};
}

/// Copies a slot of `size` bytes, except what is unused. Others may change the bytes at `from`
/// meanwhile, so each number is read from the copy.
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

/// Writes the used parts without gaps to where the slot lies, anywhere in front of it, or to other
/// memory. No other thread may change the slot meanwhile.
void packUsed(std::byte* to, const std::byte* slot, std::size_t size, BoundedLevels levels);

/// Puts what packUsed() has written back in its place, also when it arrives bit by bit.
class UsedReader {
 public:
  UsedReader(std::byte* slot, std::size_t size, BoundedLevels levels)
      : slot_(slot), size_(size), levels_(levels) {}

  /// Takes as much of `packed` as belongs to the slot, and returns what is left.
  std::span<const std::byte> take(std::span<const std::byte> packed);
  /// Returns true if the whole slot is there.
  bool done() const { return next().begin == size_; }
  /// Returns the place up to which the slot is there or unused.
  std::size_t place() const { return place_; }

 private:
  UsedPart next() const { return nextUsedPart(slot_, place_, size_, levels_); }

  std::byte* slot_;
  std::size_t size_;
  BoundedLevels levels_;
  std::size_t place_ = 0;
};

}  // namespace suture
