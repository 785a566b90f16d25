#pragma once
// These judge what a slot holds. Generated checks are built on these overloads; any thread may use
// them.
//
//   isValid(slot, path)   may a handler act on it: every number is finite. `path`, unless it is
//                         null, is told where the first is that is not

#include <suture/base/field_path.h>
#include <suture/base/slots/slots.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

namespace suture {

template <Number T>
bool isValid(T value, FieldPath* = nullptr) {
  if constexpr (std::is_floating_point_v<T>) {
    return std::isfinite(value);
  } else {
    return true;
  }
}
/// Returns the float that is nearest to a bound.
inline float nearestFloat(double bound) {
  constexpr double kMost = std::numeric_limits<float>::max();
  return static_cast<float>(std::isinf(bound) ? bound : std::clamp(bound, -kMost, kMost));
}
/// Compares a float with what its bounds are as floats, because 0.1F is more than 0.1.
template <Number T>
bool inRange(T value, double lowest, double highest) {
  if constexpr (std::is_same_v<T, float>) {
    return value >= nearestFloat(lowest) && value <= nearestFloat(highest);
  } else {
    return static_cast<double>(value) >= lowest && static_cast<double>(value) <= highest;
  }
}

/// Adds to a path what tells an element of a sequence from the others: its place, or its key.
template <class T>
void enterElement(FieldPath& path, const T&, std::size_t index) {
  path.enterElement(index);
}
template <Number Key, class Value>
void enterElement(FieldPath& path, const SlotEntry<Key, Value>& entry, std::size_t) {
  path.enterKey(static_cast<std::int64_t>(entry.key));
}
template <std::uint32_t N, class Value>
void enterElement(FieldPath& path, const SlotEntry<BoundedText<N>, Value>& entry, std::size_t) {
  path.enterKey(std::string_view(elements(entry.key), sizeOf(entry.key)));
}

template <class T, class Check>
bool allOf(const T* begin, std::size_t count, FieldPath* path, const Check& check) {
  const T* const refused = std::find_if_not(begin, begin + count, check);
  if (refused == begin + count) return true;
  if (path != nullptr) enterElement(*path, *refused, static_cast<std::size_t>(refused - begin));
  return false;
}
/// Checks each element by `check(element)`; returns false for a list of more than it has room for.
/// `path` gets the element that is refused; it is null for a type in which C++ does not count so.
template <class T, std::size_t N, class Check>
bool allOf(const std::array<T, N>& slot, FieldPath* path, const Check& check) {
  return allOf(slot.data(), N, path, check);
}
template <class T, std::uint32_t N, class Check>
bool allOf(const BoundedList<T, N>& slot, FieldPath* path, const Check& check) {
  return sizeOf(slot) == slot.size && allOf(elements(slot), slot.size, path, check);
}
template <Number T, std::size_t N>
bool isValid(const std::array<T, N>& slot, FieldPath* path = nullptr) {
  return allOf(slot, path, [](T value) { return isValid(value); });
}
template <Number T, std::uint32_t N>
bool isValid(const BoundedList<T, N>& slot, FieldPath* path = nullptr) {
  return allOf(slot, path, [](T value) { return isValid(value); });
}

// --- sets, maps, optionals, tuples, variants and matrices of any size

template <std::uint32_t N>
bool isValid(const BoundedText<N>&, FieldPath*);
template <class S, std::size_t N>
bool isValid(const std::array<S, N>& slot, FieldPath* path);
template <class S, std::uint32_t N>
bool isValid(const BoundedList<S, N>& slot, FieldPath* path);
template <class Key, class Value>
bool isValid(const SlotEntry<Key, Value>& slot, FieldPath* path);
template <class S>
bool isValid(const SlotOptional<S>& slot, FieldPath* path);
template <class S>
bool isValid(const OpenOptional<S>& slot, FieldPath* path);
template <class... S>
bool isValid(const SlotTuple<S...>& slot, FieldPath* path);
template <class... S>
bool isValid(const SlotVariant<S...>& slot, FieldPath* path);
template <Number S, std::uint32_t R, std::uint32_t C>
bool isValid(const BoundedMatrix<S, R, C>& slot, FieldPath* = nullptr);
inline bool isValid(SlotNothing, FieldPath*) { return true; }

// A path has no entry for an optional, since its value is the thing itself.
template <class S, class Check>
bool allOf(const SlotOptional<S>& slot, FieldPath*, const Check& check) {
  return slot.present == 0 || check(slot.value);
}
template <class S, class Check>
bool allOf(const OpenOptional<S>& slot, FieldPath*, const Check& check) {
  return slot.present == 0 || check(*slot.value);
}
template <Number S, std::uint32_t R, std::uint32_t C, class Check>
bool allOf(const BoundedMatrix<S, R, C>& slot, FieldPath*, const Check& check) {
  const auto [rows, columns] = extentOf(slot);
  if (rows != slot.rows || columns != slot.columns) return false;
  return allOf(elements(slot), std::size_t{rows} * columns, nullptr, check);
}

template <std::uint32_t N>
bool isValid(const BoundedText<N>&, FieldPath*) {
  return true;
}
template <class S, std::size_t N>
bool isValid(const std::array<S, N>& slot, FieldPath* path) {
  return allOf(slot, path, [path](const S& element) { return isValid(element, path); });
}
template <class S, std::uint32_t N>
bool isValid(const BoundedList<S, N>& slot, FieldPath* path) {
  return allOf(slot, path, [path](const S& element) { return isValid(element, path); });
}
template <class Key, class Value>
bool isValid(const SlotEntry<Key, Value>& slot, FieldPath* path) {
  return isValid(slot.value, path);  // no key is a real number
}
template <class S>
bool isValid(const SlotOptional<S>& slot, FieldPath* path) {
  return allOf(slot, path, [path](const S& value) { return isValid(value, path); });
}
template <class S>
bool isValid(const OpenOptional<S>& slot, FieldPath* path) {
  return allOf(slot, path, [path](const S& value) { return isValid(value, path); });
}
/// A Valid is isValid() as a check that can be passed on.
struct Valid {
  template <class Slot>
  bool operator()(const Slot& slot) const {
    return isValid(slot, path);
  }
  FieldPath* path;
};

template <class Tuple, std::size_t... I, class... Check>
bool allItemsAt(const Tuple& slot, FieldPath* path, std::index_sequence<I...>,
                const Check&... check) {
  const auto told = [path](bool isValid, std::size_t index) {
    if (!isValid && path != nullptr) path->enterElement(index);
    return isValid;
  };
  return (told(check(item<I>(slot)), I) && ...);
}
/// Checks each member of a tuple by its own check.
template <class... S, class... Check>
bool allItems(const SlotTuple<S...>& slot, FieldPath* path, const Check&... check) {
  return allItemsAt(slot, path, std::index_sequence_for<S...>(), check...);
}
template <class... S>
bool isValid(const SlotTuple<S...>& slot, FieldPath* path) {
  return allItems(slot, path, [path](const S& one) { return isValid(one, path); }...);
}
template <class Slot, std::size_t... I, class... Check>
bool theOneAt(const Slot& slot, std::index_sequence<I...>, const Check&... check) {
  return ((slot.index == I && check(alternative<I>(slot))) || ...);
}
/// Checks the alternative that a variant holds by the check for it.
template <class... S, class... Check>
bool theOneOf(const SlotVariant<S...>& slot, FieldPath*, const Check&... check) {
  return theOneAt(slot, std::index_sequence_for<S...>(), check...);
}
template <class... S>
bool isValid(const SlotVariant<S...>& slot, FieldPath* path) {
  return theOneOf(slot, path, [path](const S& one) { return isValid(one, path); }...);
}
template <Number S, std::uint32_t R, std::uint32_t C>
bool isValid(const BoundedMatrix<S, R, C>& slot, FieldPath*) {
  return allOf(slot, nullptr, [](S coefficient) { return isValid(coefficient); });
}

}  // namespace suture
