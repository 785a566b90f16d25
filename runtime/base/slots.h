#pragma once
// Slots: the flat, bounded, trivially copyable twin of every type in a contract. They travel in
// mailboxes, state rows and shared memory. Generated code defines a struct for each SUTURE_TYPE and
// its store() and load() from the overloads below; all are free of allocation once a target has
// grown to its capacity.
//
//   store(value, slot): C++ -> slot; false if the value exceeds the capacity of the slot
//   load(slot, value):  slot -> C++; reuses what the value already owns

#include <suture/annotate.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <chrono>
#include <concepts>
#include <cstdint>
#include <deque>
#include <string>
#include <type_traits>
#include <vector>

namespace suture {

/// A string of at most N bytes.
template <std::uint32_t N>
struct BoundedText {
  std::uint32_t size;
  char data[N];
};

/// A list of at most N elements.
template <class Element, std::uint32_t N>
struct BoundedList {
  std::uint32_t size;
  Element data[N];
};

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

template <class E>
requires std::is_enum_v<E>
bool store(E value, std::underlying_type_t<E>& slot) {
  slot = static_cast<std::underlying_type_t<E>>(value);
  return true;
}
template <class E>
requires std::is_enum_v<E>
void load(std::underlying_type_t<E> slot, E& value) { value = static_cast<E>(slot); }

/// Durations of a real representation travel as their count, whatever it is; the others and time
/// points as nanoseconds.
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

template <std::uint32_t N>
bool store(const std::string& value, BoundedText<N>& slot) {
  if (value.size() > N) return false;
  slot.size = static_cast<std::uint32_t>(value.size());
  std::copy_n(value.data(), value.size(), slot.data);
  return true;
}
template <std::uint32_t N>
void load(const BoundedText<N>& slot, std::string& value) {
  value.assign(slot.data, std::min(slot.size, N));
}

/// Fixed Eigen matrices and vectors, column-major.
template <Number S, int Rows, int Columns, int Options, std::size_t N>
bool store(const Eigen::Matrix<S, Rows, Columns, Options>& value, std::array<S, N>& slot) {
  static_assert(N == std::size_t{Rows} * std::size_t{Columns});
  Eigen::Map<Eigen::Matrix<S, Rows, Columns>>(slot.data()) = value;
  return true;
}
template <Number S, int Rows, int Columns, int Options, std::size_t N>
void load(const std::array<S, N>& slot, Eigen::Matrix<S, Rows, Columns, Options>& value) {
  static_assert(N == std::size_t{Rows} * std::size_t{Columns});
  value = Eigen::Map<const Eigen::Matrix<S, Rows, Columns>>(slot.data());
}

/// Quaternions as w, x, y, z.
template <Number S>
bool store(const Eigen::Quaternion<S>& value, std::array<S, 4>& slot) {
  slot = {value.w(), value.x(), value.y(), value.z()};
  return true;
}
template <Number S>
void load(const std::array<S, 4>& slot, Eigen::Quaternion<S>& value) {
  value = Eigen::Quaternion<S>(slot[0], slot[1], slot[2], slot[3]);
}

/// Rigid and affine transforms as the linear part, column-major, then the translation.
template <int Mode>
bool store(const Eigen::Transform<double, 3, Mode>& value, std::array<double, 12>& slot) {
  Eigen::Map<Eigen::Matrix<double, 3, 4>>(slot.data()) = value.affine();
  return true;
}
template <int Mode>
void load(const std::array<double, 12>& slot, Eigen::Transform<double, 3, Mode>& value) {
  value.affine() = Eigen::Map<const Eigen::Matrix<double, 3, 4>>(slot.data());
  value.makeAffine();
}

/// What has a suture::Wire travels as that says.
template <class T>
concept Hooked = requires {
  typename Wire<T>::Type;
};

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

// The element's own overloads are found at instantiation: those above, and a generated type's by
// its namespace. Arrays and lists of lists need these two declared before their bodies.
template <class T, std::size_t N, class S>
bool store(const std::array<T, N>& value, std::array<S, N>& slot);
template <class T, std::size_t N, class S>
void load(const std::array<S, N>& slot, std::array<T, N>& value);
template <class T, std::size_t N, class S>
bool store(const T (&value)[N], std::array<S, N>& slot);
template <class T, std::size_t N, class S>
void load(const std::array<S, N>& slot, T (&value)[N]);

template <class T, class S, std::uint32_t N>
bool store(const std::vector<T>& value, BoundedList<S, N>& slot) {
  if (value.size() > N) return false;
  slot.size = static_cast<std::uint32_t>(value.size());
  bool fits = true;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const T& element = value[i];  // binds a vector<bool> proxy to a bool
    fits = store(element, slot.data[i]) && fits;
  }
  return fits;
}
template <class T, class S, std::uint32_t N>
void load(const BoundedList<S, N>& slot, std::vector<T>& value) {
  value.resize(std::min(slot.size, N));
  for (std::size_t i = 0; i < value.size(); ++i) {
    if constexpr (std::is_same_v<T, bool>) {
      value[i] = slot.data[i] != 0;
    } else {
      load(slot.data[i], value[i]);
    }
  }
}

template <class T, class S, std::uint32_t N>
bool store(const std::deque<T>& value, BoundedList<S, N>& slot) {
  if (value.size() > N) return false;
  slot.size = static_cast<std::uint32_t>(value.size());
  bool fits = true;
  for (std::uint32_t i = 0; i < slot.size; ++i) fits = store(value[i], slot.data[i]) && fits;
  return fits;
}
template <class T, class S, std::uint32_t N>
void load(const BoundedList<S, N>& slot, std::deque<T>& value) {
  value.resize(std::min(slot.size, N));
  for (std::uint32_t i = 0; i < value.size(); ++i) load(slot.data[i], value[i]);
}

template <class T, std::size_t N, class S>
bool store(const std::array<T, N>& value, std::array<S, N>& slot) {
  bool fits = true;
  for (std::size_t i = 0; i < N; ++i) fits = store(value[i], slot[i]) && fits;
  return fits;
}
template <class T, std::size_t N, class S>
void load(const std::array<S, N>& slot, std::array<T, N>& value) {
  for (std::size_t i = 0; i < N; ++i) load(slot[i], value[i]);
}

template <class T, std::size_t N, class S>
bool store(const T (&value)[N], std::array<S, N>& slot) {
  bool fits = true;
  for (std::size_t i = 0; i < N; ++i) fits = store(value[i], slot[i]) && fits;
  return fits;
}
template <class T, std::size_t N, class S>
void load(const std::array<S, N>& slot, T (&value)[N]) {
  for (std::size_t i = 0; i < N; ++i) load(slot[i], value[i]);
}

}  // namespace suture

#include <suture/base/composite_slots.h>
#include <suture/base/keyed_slots.h>
#include <suture/base/matrix_slots.h>
