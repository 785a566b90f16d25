#pragma once
// Copies of a slot that take only what is used of its lists, texts and matrices.

#include <suture/base/slots/slot_forms.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace suture {

/// A list, a text or a matrix that lies in a slot. What lies behind its last element means nothing.
/// Places are bytes from the beginning of the slot.
struct BoundedLevel {
  std::uint32_t size = 0;         ///< place of the number of elements, or of rows and columns
  std::uint32_t data = 0;         ///< place of the first element, behind `size`
  std::uint32_t stride = 0;       ///< bytes of an element
  std::uint32_t capacity = 0;     ///< elements, or rows
  std::uint32_t mostColumns = 0;  ///< 0: it is no matrix

  constexpr std::uint32_t mostBytes() const {
    return stride * capacity * (mostColumns == 0 ? 1 : mostColumns);
  }
  /// Returns how many bytes are used, at most as many as there are: a slot may have any bytes.
  std::uint32_t usedBytes(const std::byte* slot) const {
    const std::uint32_t elements = std::min(numberAt(slot, size), capacity);
    if (mostColumns == 0) return stride * elements;
    return stride * elements * std::min(numberAt(slot, size + sizeof(elements)), mostColumns);
  }

 private:
  static std::uint32_t numberAt(const std::byte* slot, std::size_t place) {
    std::uint32_t number;
    std::memcpy(&number, slot + place, sizeof(number));
    return number;
  }
};

/// The levels of a slot that lie in no other, in the order of their places.
using BoundedLevels = std::span<const BoundedLevel>;

namespace bounded {

template <class Element, std::uint32_t N>
constexpr BoundedLevel levelAt(std::size_t place, const BoundedList<Element, N>*) {
  using List = BoundedList<Element, N>;
  return {.size = static_cast<std::uint32_t>(place + offsetof(List, size)),
          .data = static_cast<std::uint32_t>(place + offsetof(List, data)),
          .stride = sizeof(Element),
          .capacity = N};
}

template <class S, std::uint32_t R, std::uint32_t C>
constexpr BoundedLevel levelAt(std::size_t place, const BoundedMatrix<S, R, C>*) {
  using Matrix = BoundedMatrix<S, R, C>;
  return {.size = static_cast<std::uint32_t>(place + offsetof(Matrix, rows)),
          .data = static_cast<std::uint32_t>(place + offsetof(Matrix, data)),
          .stride = sizeof(S),
          .capacity = R,
          .mostColumns = C};
}

}  // namespace bounded

/// The level of form `Form` that lies at `place`.
template <class Form>
constexpr BoundedLevel levelAt(std::size_t place) {
  return bounded::levelAt(place, static_cast<const Form*>(nullptr));
}

/// Copies a slot of `size` bytes to `to`, except what nobody reads. What lies at `from` may change
/// meanwhile: each size is read from the copy.
inline void copyUsed(std::byte* to, const std::byte* from, std::size_t size, BoundedLevels levels) {
  std::size_t place = 0;
  for (const BoundedLevel& level : levels) {
    std::memcpy(to + place, from + place, level.data - place);
    std::memcpy(to + level.data, from + level.data, level.usedBytes(to));
    place = level.data + level.mostBytes();
  }
  std::memcpy(to + place, from + place, size - place);
}

/// Returns how many bytes packUsed() writes.
inline std::size_t usedSize(const std::byte* slot, std::size_t size, BoundedLevels levels) {
  for (const BoundedLevel& level : levels) size -= level.mostBytes() - level.usedBytes(slot);
  return size;
}

/// Writes the same bytes one behind the other. Nobody else may change the slot meanwhile.
inline void packUsed(std::byte* to, const std::byte* slot, std::size_t size, BoundedLevels levels) {
  std::size_t place = 0;
  const auto write = [&](std::size_t bytes) {
    std::memcpy(to, slot + place, bytes);
    to += bytes;
    place += bytes;
  };
  for (const BoundedLevel& level : levels) {
    write(level.data - place);
    write(level.usedBytes(slot));
    place = level.data + level.mostBytes();
  }
  write(size - place);
}

/// Puts what packUsed() has written where it belongs in a slot. Returns false if `packed`, which
/// may be any bytes, is not that; the slot may have any bytes then.
inline bool unpackUsed(std::byte* slot, std::span<const std::byte> packed, std::size_t size,
                       BoundedLevels levels) {
  std::size_t place = 0;
  const auto read = [&](std::size_t bytes) {
    if (bytes > packed.size()) return false;
    std::memcpy(slot + place, packed.data(), bytes);
    packed = packed.subspan(bytes);
    place += bytes;
    return true;
  };
  for (const BoundedLevel& level : levels) {
    if (!read(level.data - place) || !read(level.usedBytes(slot))) return false;
    place = level.data + level.mostBytes();
  }
  return read(size - place) && packed.empty();
}

}  // namespace suture
