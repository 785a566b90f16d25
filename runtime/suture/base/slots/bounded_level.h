#pragma once
// This tells where the lists, texts and matrices of a slot lie, of which a part may be unused.

#include <suture/base/slots/slot_forms.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace suture {

/// Tells where a list, a text or a matrix lies in a slot. The bytes behind its last element mean
/// nothing. Places are bytes from the beginning of the slot.
struct BoundedLevel {
  std::uint32_t size = 0;         ///< place of the number of elements, or of rows and columns
  std::uint32_t data = 0;         ///< place of the first element, behind `size`
  std::uint32_t stride = 0;       ///< bytes of an element
  std::uint32_t capacity = 0;     ///< elements, or rows
  std::uint32_t mostColumns = 0;  ///< 0 for what is no matrix

  constexpr std::uint32_t mostBytes() const {
    return stride * capacity * (mostColumns == 0 ? 1 : mostColumns);
  }
  /// Returns how many bytes are used, at most the capacity, because a slot may have any bytes.
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

/// BoundedLevels are the levels of a slot that lie in no other level, in the order of their places.
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

/// Returns the level of form `Form` that lies at `place`.
template <class Form>
constexpr BoundedLevel levelAt(std::size_t place) {
  return bounded::levelAt(place, static_cast<const Form*>(nullptr));
}

}  // namespace suture
