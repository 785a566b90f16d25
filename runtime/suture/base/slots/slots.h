#pragma once
// These convert slots, see slot_forms.h: arrays, lists and fixed Eigen types here, and all others
// in what this includes. Generated code defines a struct for each SUTURE_TYPE, and its store() and
// load() from these. None allocates once a target has grown to its capacity.

#include <suture/base/slots/slot_forms.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <deque>
#include <type_traits>
#include <utility>
#include <vector>

namespace suture {

/// Handles fixed Eigen matrices and vectors, column-major.
template <Number S, int Rows, int Columns, int Options>
struct ArraySlot<Eigen::Matrix<S, Rows, Columns, Options>> {
  using Matrix = Eigen::Matrix<S, Rows, Columns, Options>;
  using Form = std::array<S, std::size_t{Rows} * std::size_t{Columns}>;
  static bool write(const Matrix& value, Form& slot) {
    Eigen::Map<Eigen::Matrix<S, Rows, Columns>>(slot.data()) = value;
    return true;
  }
  static void read(const Form& slot, Matrix& value) {
    value = Eigen::Map<const Eigen::Matrix<S, Rows, Columns>>(slot.data());
  }
};

/// Handles quaternions as w, x, y, z.
template <Number S>
struct ArraySlot<Eigen::Quaternion<S>> {
  static bool write(const Eigen::Quaternion<S>& value, std::array<S, 4>& slot) {
    slot = {value.w(), value.x(), value.y(), value.z()};
    return true;
  }
  static void read(const std::array<S, 4>& slot, Eigen::Quaternion<S>& value) {
    value = Eigen::Quaternion<S>(slot[0], slot[1], slot[2], slot[3]);
  }
};

/// Handles rigid and affine transforms as the linear part, column-major, and then the translation.
template <int Mode>
struct ArraySlot<Eigen::Transform<double, 3, Mode>> {
  static bool write(const Eigen::Transform<double, 3, Mode>& value, std::array<double, 12>& slot) {
    Eigen::Map<Eigen::Matrix<double, 3, 4>>(slot.data()) = value.affine();
    return true;
  }
  static void read(const std::array<double, 12>& slot, Eigen::Transform<double, 3, Mode>& value) {
    value.affine() = Eigen::Map<const Eigen::Matrix<double, 3, 4>>(slot.data());
    value.makeAffine();
  }
};

// The overloads of the element are found at instantiation: those of slot_forms.h, and others by
// their namespace.
struct ElementByElement {
  template <class Value, class S, std::size_t N>
  static bool write(const Value& value, std::array<S, N>& slot) {
    bool fits = true;
    for (std::size_t i = 0; i < N; ++i) fits = store(value[i], slot[i]) && fits;
    return fits;
  }
  template <class Value, class S, std::size_t N>
  static void read(const std::array<S, N>& slot, Value& value) {
    for (std::size_t i = 0; i < N; ++i) load(slot[i], value[i]);
  }
};
template <class S, class T, std::size_t N>
void reserve(const std::array<S, N>*, std::array<T, N>& value) {
  for (T& element : value) reserveFor<S>(element);
}
template <class S, class T, std::size_t N>
void reserve(const std::array<S, N>*, T (&value)[N]) {
  for (T& element : value) reserveFor<S>(element);
}
template <class T, std::size_t N>
struct ArraySlot<std::array<T, N>> : ElementByElement {};
template <class T, std::size_t N>
struct ArraySlot<T[N]> : ElementByElement {};

/// This is true for numbers of which a vector is copied as one block.
template <class T, class S>
inline constexpr bool liesAlike = Number<T>&& std::is_same_v<T, S>;

template <class T, class S, std::uint32_t N>
bool store(const std::vector<T>& value, BoundedList<S, N>& slot) {
  if (!resize(slot, value.size())) return false;
  std::size_t size = value.size();
  if constexpr (N != kUnbounded) size = std::min(size, std::size_t{N});  // as g++ 12 cannot tell
  if constexpr (liesAlike<T, S>) return std::copy_n(value.data(), size, elements(slot)), true;
  bool fits = true;
  for (std::size_t i = 0; i < size; ++i) {
    const T& element = value[i];  // binds a vector<bool> proxy to a bool
    fits = store(element, slot.data[i]) && fits;
  }
  return fits;
}

/// This is false if it may not compile that a vector takes its elements to a larger place: it
/// copies them if their move may throw, and a struct with a std::deque says that it has a copy
/// whatever it holds. What owns no memory has one.
template <class T>
inline constexpr bool hasLargerPlace =
    std::is_nothrow_move_constructible_v<T> || !std::is_copy_constructible_v<T> ||
    std::is_trivially_destructible_v<T>;

template <class T>
void resizeTo(std::size_t size, std::vector<T>& value) {
  if constexpr (hasLargerPlace<T>) {
    value.resize(size);
  } else if (size <= value.size()) {
    value.erase(value.begin() + static_cast<std::ptrdiff_t>(size), value.end());
  } else {
    std::vector<T> larger(size);
    std::move(value.begin(), value.end(), larger.begin());
    value.swap(larger);
  }
}

template <class T, class S, std::uint32_t N>
void load(const BoundedList<S, N>& slot, std::vector<T>& value) {
  if constexpr (liesAlike<T, S>) return value.assign(elements(slot), elements(slot) + sizeOf(slot));
  resizeTo(sizeOf(slot), value);
  for (std::size_t i = 0; i < value.size(); ++i) {
    if constexpr (std::is_same_v<T, bool>) {
      value[i] = slot.data[i] != 0;
    } else {
      load(slot.data[i], value[i]);
    }
  }
}

template <class S, std::uint32_t N, class T>
void reserve(const BoundedList<S, N>*, std::vector<T>& value) {
  if constexpr (hasLargerPlace<T>) value.reserve(N);  // others get a new place when they grow
}

template <class T, class S, std::uint32_t N>
bool store(const std::deque<T>& value, BoundedList<S, N>& slot) {
  if (!resize(slot, value.size())) return false;
  const auto size = static_cast<std::uint32_t>(value.size());
  bool fits = true;
  for (std::uint32_t i = 0; i < size; ++i) fits = store(value[i], slot.data[i]) && fits;
  return fits;
}
template <class T, class S, std::uint32_t N>
void load(const BoundedList<S, N>& slot, std::deque<T>& value) {
  value.resize(sizeOf(slot));
  for (std::uint32_t i = 0; i < value.size(); ++i) load(slot.data[i], value[i]);
}

}  // namespace suture

#include <suture/base/slots/composite_slots.h>
#include <suture/base/slots/keyed_slots.h>
#include <suture/base/slots/matrix_slots.h>
