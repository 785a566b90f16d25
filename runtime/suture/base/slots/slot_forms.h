#pragma once
// These are the forms of slots, and the conversions that need no more than those: all that the
// generated header of a contract needs. A slot is the form of a contract's type that travels in
// mailboxes, state rows and shared memory. It is flat and trivially copyable where every level has
// a capacity. A level without one owns memory; such a slot lies outside its record, see
// shared_slot.h.
//
//   store(value, slot): C++ -> slot; false if the value exceeds the capacity of the slot. Another
//                       process may write to the slot meanwhile, so nothing that is read back from
//                       it may decide how far store() reads or writes.
//   load(slot, value):  slot -> C++; reuses what the value already owns

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <ratio>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

namespace suture {

class FieldPath;

/// Holds at most N elements.
template <class Element, std::uint32_t N>
struct BoundedList {
  std::uint32_t size;
  Element data[N];
};

/// Takes the place of a capacity where there is none.
inline constexpr std::uint32_t kUnbounded = 0;

/// Holds any number of elements; resize() has made room for `room`.
template <class Element>
struct BoundedList<Element, kUnbounded> {
  std::uint32_t size = 0;
  std::uint32_t room = 0;
  std::unique_ptr<Element[]> data;
};
template <class Element>
using OpenList = BoundedList<Element, kUnbounded>;

/// Holds a string of at most N bytes.
template <std::uint32_t N>
using BoundedText = BoundedList<char, N>;
using OpenText = BoundedText<kUnbounded>;

/// Holds a matrix of at most R x C, column after column without gaps.
template <class S, std::uint32_t R, std::uint32_t C>
struct BoundedMatrix {
  std::uint32_t rows, columns;
  S data[std::size_t{R} * C];
};

/// Holds a matrix that lacks one bound, or both.
template <class S, std::uint32_t R, std::uint32_t C>
requires(R == kUnbounded || C == kUnbounded) struct BoundedMatrix<S, R, C> {
  std::uint32_t rows = 0, columns = 0;
  OpenList<S> data;
};
template <class S>
using OpenMatrix = BoundedMatrix<S, kUnbounded, kUnbounded>;

/// Holds one entry of a map.
template <class Key, class Value>
struct SlotEntry {
  Key key;
  Value value;
};

/// SlotNothing is the slot of std::monostate.
struct SlotNothing {};

/// Holds an optional; `value` means something only if `present` is not 0.
template <class S>
struct SlotOptional {
  std::uint8_t present;
  S value;
};

/// Holds an optional of a type that contains its own kind, and so cannot lie in itself.
template <class S>
struct OpenOptional {
  std::uint8_t present = 0;
  std::unique_ptr<S> value;
};

/// Holds a tuple; unlike std::tuple, it may be copied as bytes.
template <class Head, class... Tail>
struct SlotTuple {
  Head head;
  SlotTuple<Tail...> tail;
};
template <class Head>
struct SlotTuple<Head> {
  Head head;
};

/// Holds a variant: alternative `index` lies in `data`.
template <class... S>
struct SlotVariant {
  std::uint32_t index;
  alignas(S...) std::byte data[std::max({sizeof(S)...})];
};

/// Holds a variant of which an alternative owns memory; each alternative has a place of its own.
template <class... S>
requires(!(std::is_trivially_copyable_v<S> && ...)) struct SlotVariant<S...> {
  std::uint32_t index = 0;
  SlotTuple<S...> all;
};

/// Holds for what C++ computes with.
template <class T>
concept Number = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;

template <Number T>
bool store(T value, T& slot) {
  slot = value;
  return true;
}
template <Number T>
void load(T slot, T& value) {
  value = slot;
}

inline bool store(bool value, std::uint8_t& slot) {
  slot = value ? 1 : 0;
  return true;
}
inline void load(std::uint8_t slot, bool& value) { value = slot != 0; }

/// Matches integers of foreign structs that differ in type from those of a slot. Whether a char has
/// a sign depends on the machine; its bits are the same.
template <class T>
concept ForeignInteger = std::is_same_v<T, char> || std::is_same_v<T, long long> ||
    std::is_same_v<T, unsigned long long>;

template <ForeignInteger T, Number S>
requires(!std::is_same_v<T, S> && sizeof(T) == sizeof(S)) bool store(T value, S& slot) {
  slot = static_cast<S>(value);
  return true;
}
template <ForeignInteger T, Number S>
requires(!std::is_same_v<T, S> && sizeof(T) == sizeof(S)) void load(S slot, T& value) {
  value = static_cast<T>(slot);
}

template <class E>
requires std::is_enum_v<E>
bool store(E value, std::underlying_type_t<E>& slot) {
  slot = static_cast<std::underlying_type_t<E>>(value);
  return true;
}
template <class E>
requires std::is_enum_v<E>
void load(std::underlying_type_t<E> slot, E& value) { value = static_cast<E>(slot); }

/// A duration that counts in floating point travels as its count, in its own unit. The others and
/// time points travel as nanoseconds.
template <std::floating_point Rep, class Period>
bool store(std::chrono::duration<Rep, Period> value, double& slot) {
  slot = static_cast<double>(value.count());
  return true;
}
template <std::floating_point Rep, class Period>
void load(double slot, std::chrono::duration<Rep, Period>& value) {
  value = std::chrono::duration<Rep, Period>(static_cast<Rep>(slot));
}
template <class Rep, class Period>
bool store(std::chrono::duration<Rep, Period> value, std::int64_t& slot) {
  using Factor = std::ratio_divide<Period, std::nano>;
  if constexpr (Factor::num > Factor::den) {  // its longest may be more nanoseconds than fit
    constexpr std::int64_t most =
        std::chrono::nanoseconds::max().count() / Factor::num * Factor::den;
    if (std::cmp_greater(value.count(), most) || std::cmp_less(value.count(), -most)) return false;
  }
  slot = std::chrono::duration_cast<std::chrono::nanoseconds>(value).count();
  return true;
}
template <class Rep, class Period>
void load(std::int64_t slot, std::chrono::duration<Rep, Period>& value) {
  using Target = std::chrono::duration<Rep, Period>;
  value = std::chrono::duration_cast<Target>(std::chrono::nanoseconds(slot));
}
template <class Clock, class D>
bool store(std::chrono::time_point<Clock, D> value, std::int64_t& slot) {
  return store(value.time_since_epoch(), slot);
}
template <class Clock, class D>
void load(std::int64_t slot, std::chrono::time_point<Clock, D>& value) {
  D sinceEpoch;
  load(slot, sinceEpoch);
  value = std::chrono::time_point<Clock, D>(sinceEpoch);
}

/// Limits what one level without a capacity may take up; it is more than any message may have.
inline constexpr std::size_t kLargestOpenLevel = std::size_t{64} << 20;

/// Makes room for `size` elements, with unspecified values. Returns false if they are too many.
template <class Element, std::uint32_t N>
bool resize(BoundedList<Element, N>& slot, std::size_t size) {
  if constexpr (N == kUnbounded) {
    if (size > kLargestOpenLevel / sizeof(Element)) return false;
    if (size > slot.room) {
      slot.data = std::make_unique<Element[]>(size);
      slot.room = static_cast<std::uint32_t>(size);
    }
  } else if (size > N) {
    return false;
  }
  slot.size = static_cast<std::uint32_t>(size);
  return true;
}

/// Returns the number of elements, at most the capacity, because the bytes of a slot may be wrong.
template <class Element, std::uint32_t N>
std::uint32_t sizeOf(const BoundedList<Element, N>& slot) {
  if constexpr (N == kUnbounded) {
    return slot.size;  // this kind is never copied as bytes, so its size is right
  } else {
    return std::min(slot.size, N);
  }
}

/// Returns where the elements begin.
template <class Element, std::uint32_t N>
Element* elements(BoundedList<Element, N>& slot) {
  if constexpr (N == kUnbounded) {
    return slot.data.get();
  } else {
    return slot.data;
  }
}
template <class Element, std::uint32_t N>
const Element* elements(const BoundedList<Element, N>& slot) {
  return elements(const_cast<BoundedList<Element, N>&>(slot));
}

/// Returns all elements.
template <class Element, std::uint32_t N>
std::span<Element> elementsIn(BoundedList<Element, N>& slot) {
  return {elements(slot), sizeOf(slot)};
}

template <std::uint32_t N>
bool store(const std::string& value, BoundedText<N>& slot) {
  if (!resize(slot, value.size())) return false;
  std::copy_n(value.data(), value.size(), elements(slot));
  return true;
}
template <std::uint32_t N>
void load(const BoundedText<N>& slot, std::string& value) {
  value.assign(elements(slot), sizeOf(slot));
}

/// Gives `values` the memory that the largest content of their slot needs, so that no load() into
/// them allocates. A value that holds others, such as a vector of strings, gets only its own
/// memory. The forms that need any have overloads here, in slots.h and in generated code.
template <class Slot, class... Values>
void reserve(const Slot*, Values&...) {}
template <std::uint32_t N>
void reserve(const BoundedText<N>*, std::string& value) {
  value.reserve(N);
}
template <class Slot, class... Values>
void reserveFor(Values&... values) {
  reserve(static_cast<const Slot*>(nullptr), values...);
}

/// Matches types that have a suture::Wire, which says how they travel.
template <class T>
concept Hooked = requires {
  typename Wire<T>::Type;
};

/// Writes a T into a std::array and reads it back; slots.h defines this for arrays and for Eigen's
/// fixed types.
template <class T>
struct ArraySlot;

template <class T, class S, std::size_t N>
requires(!Hooked<T>) bool store(const T& value, std::array<S, N>& slot) {
  return ArraySlot<T>::write(value, slot);
}
template <class T, class S, std::size_t N>
requires(!Hooked<T>) void load(const std::array<S, N>& slot, T& value) {
  ArraySlot<T>::read(slot, value);
}

// These come after the functions for arrays because a hook may travel as an array: the lookup by
// arguments of namespace std or Eigen would not find what is declared later.
template <Hooked T, class S>
bool store(const T& value, S& slot) {
  return store(Wire<T>::to(value), slot);
}
template <class S, Hooked T>
void load(const S& slot, T& value) {
  typename Wire<T>::Type form{};
  load(slot, form);
  value = Wire<T>::from(form);
}

}  // namespace suture
