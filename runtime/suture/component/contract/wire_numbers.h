#pragma once
// By these numbers two processes name events and columns to each other.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace suture {

/// Each place in a contract's tables has its number on the wire here: the place in the lock, which
/// stays when a base of the contract gets more. Empty means that the two are equal.
using WireNumbers = std::span<const std::uint8_t>;

/// Returns a set of events or columns, one bit each, in wire numbers.
inline std::uint64_t toWireNumbers(WireNumbers numbers, std::uint64_t set) {
  if (numbers.empty()) return set;
  std::uint64_t wire = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) wire |= (set >> i & 1) << numbers[i];
  return wire;
}

/// Returns the number of the one at `place`.
inline std::uint16_t numberAt(WireNumbers numbers, std::uint16_t place) {
  return numbers.empty() ? place : numbers[place];
}

/// Returns the place of a received number, or one beyond all places if this side does not know it.
inline std::size_t placeOf(WireNumbers numbers, std::uint16_t number) {
  if (numbers.empty()) return number;
  const auto found = std::find(numbers.begin(), numbers.end(), number);
  return static_cast<std::size_t>(found - numbers.begin());
}

/// Reads a received set, and leaves out what this side does not know.
inline std::uint64_t fromWireNumbers(WireNumbers numbers, std::uint64_t wire) {
  if (numbers.empty()) return wire;
  std::uint64_t set = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) set |= (wire >> numbers[i] & 1) << i;
  return set;
}

}  // namespace suture
