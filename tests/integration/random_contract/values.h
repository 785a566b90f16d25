#pragma once
// Random values of every kind of member that a type may have, and their comparison.

#include <Eigen/Geometry>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

namespace invented {

using Random = std::mt19937_64;

template <class T>
requires std::is_arithmetic_v<T>
void fill(T& value, Random& random) {
  if constexpr (std::is_same_v<T, bool>) {
    value = random() % 2 == 0;
  } else if constexpr (std::is_floating_point_v<T>) {
    value = static_cast<T>(std::normal_distribution<double>(0, 1e3)(random));
  } else {
    value = static_cast<T>(random());
  }
}
template <class T>
requires std::is_arithmetic_v<T>
bool same(T a, T b) { return a == b; }

template <class E>
requires std::is_enum_v<E>
void fill(E& value, Random& random) {
  constexpr std::array<E, 3> kAll{E::First, E::Second, E::Third};
  value = kAll[random() % 3];
}
template <class E>
requires std::is_enum_v<E>
bool same(E a, E b) { return a == b; }

inline void fill(std::string& value, Random& random, unsigned capacity) {
  value.resize(random() % (capacity + 1));
  for (char& c : value) c = static_cast<char>(' ' + random() % 95);
}
inline bool same(const std::string& a, const std::string& b) { return a == b; }

template <class Rep, class Period>
void fill(std::chrono::duration<Rep, Period>& value, Random& random) {
  // Less than half a year, so that it fits in nanoseconds; whole milliseconds, so that nothing is
  // rounded.
  value = std::chrono::duration_cast<std::chrono::duration<Rep, Period>>(
      std::chrono::milliseconds(static_cast<std::int64_t>(random() % 10'000'000'000)));
}
template <class Rep, class Period>
bool same(std::chrono::duration<Rep, Period> a, std::chrono::duration<Rep, Period> b) {
  if constexpr (std::is_floating_point_v<Rep>) {
    // Whole nanoseconds travel; beyond 2^53 of them the double itself is coarser.
    const std::chrono::duration<Rep, Period> coarse = a * std::numeric_limits<Rep>::epsilon();
    return std::chrono::abs(a - b) <= std::chrono::abs(coarse) + std::chrono::nanoseconds(1);
  } else {
    return a == b;
  }
}
template <class Clock, class D>
void fill(std::chrono::time_point<Clock, D>& value, Random& random) {
  D since;
  fill(since, random);
  value = std::chrono::time_point<Clock, D>(since);
}
template <class Clock, class D>
bool same(std::chrono::time_point<Clock, D> a, std::chrono::time_point<Clock, D> b) {
  return a == b;
}

template <class S, int Rows, int Columns>
void fill(Eigen::Matrix<S, Rows, Columns>& value, Random& random) {
  for (auto& coefficient : value.reshaped()) fill(coefficient, random);
}
template <class S, int Rows, int Columns>
bool same(const Eigen::Matrix<S, Rows, Columns>& a, const Eigen::Matrix<S, Rows, Columns>& b) {
  return a == b;
}
inline void fill(Eigen::Quaterniond& value, Random& random) { fill(value.coeffs(), random); }
inline bool same(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  return a.coeffs() == b.coeffs();
}
inline void fill(Eigen::Isometry3d& value, Random& random) {
  Eigen::Matrix3d rotation;
  Eigen::Vector3d translation;
  fill(rotation, random);
  fill(translation, random);
  value.linear() = rotation;
  value.translation() = translation;
}
inline bool same(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return a.matrix() == b.matrix();
}

template <class T, std::size_t N>
void fill(std::array<T, N>& value, Random& random) {
  for (T& element : value) fill(element, random);
}
template <class T, std::size_t N>
bool same(const std::array<T, N>& a, const std::array<T, N>& b) {
  return a == b;
}

template <class T, class... Inner>
void fill(std::vector<T>& value, Random& random, unsigned capacity, Inner... inner) {
  value.resize(random() % (capacity + 1));
  for (T& element : value) fill(element, random, inner...);
}
template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!same(a[i], b[i])) return false;
  }
  return true;
}

}  // namespace invented
