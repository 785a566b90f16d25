#pragma once
// kinds_peer.cpp prints a member of each kind so.

#include <Eigen/Geometry>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

namespace evolution {

template <class T>
std::string text(const T& value);

/// Prints a struct of the header, which has a member that no other has.
template <class T>
std::string structText(const T& value) {
  if constexpr (requires { value.name; }) return "(" + text(value.a) + "," + text(value.name) + ")";
  if constexpr (requires { value.value; }) return "{" + text(value.value) + "}";
  if constexpr (requires { value.label; }) {
    return "(" + text(value.level) + "," + text(value.label) + ")";
  }
  if constexpr (requires { value.turn; }) {
    return "(" + text(value.speed) + " " + text(value.offset) + " " + text(value.turn) + ")";
  }
  if constexpr (requires { value.low; }) {
    return "<" + text(value.low) + " " + text(value.high) + ">";
  }
  if constexpr (requires { value.number(); }) return "<" + text(value.number()) + ">";
  return "?";
}

template <class T>
concept Number = std::is_arithmetic_v<T>;
template <class T>
concept Range = requires(const T& value) {
  value.begin();
};
template <class T>
concept Pointer = requires(const T& value) {
  *value;
  static_cast<bool>(value);
};
template <class T>
concept Coefficients = requires(const T& value) {
  value.derived().size();
  value.data();
};

template <Number T>
std::string number(T value) {
  std::ostringstream out;
  if constexpr (sizeof(T) == 1) {
    out << static_cast<int>(value);
  } else {
    out << value;
  }
  return out.str();
}

template <Range T>
std::string rangeText(const T& values) {
  std::string all;
  for (const auto& value : values) all += (all.empty() ? "" : ",") + text(value);
  return "[" + all + "]";
}

inline std::string coefficients(const double* begin, Eigen::Index count) {
  std::string all;
  for (Eigen::Index i = 0; i < count; ++i) all += (all.empty() ? "" : " ") + number(begin[i]);
  return "[" + all + "]";
}

inline std::string kindText(std::byte value) { return number(std::to_integer<int>(value)); }
inline std::string kindText(std::monostate) { return "nothing"; }
inline std::string kindText(const std::string& value) { return "'" + value + "'"; }
template <class Rep, class Period>
std::string kindText(std::chrono::duration<Rep, Period> value) {
  return number(value.count());
}
template <class Clock, class D>
std::string kindText(std::chrono::time_point<Clock, D> value) {
  return number(value.time_since_epoch().count());
}
template <class A, class B>
std::string kindText(const std::pair<A, B>& value) {
  return "(" + text(value.first) + "," + text(value.second) + ")";
}
template <class A, class B>
std::string kindText(const std::tuple<A, B>& value) {
  return "(" + text(std::get<0>(value)) + "," + text(std::get<1>(value)) + ")";
}
template <class... T>
std::string kindText(const std::variant<T...>& value) {
  const auto chosen = [](const auto& one) { return text(one); };
  return number(value.index()) + ":" + std::visit(chosen, value);
}
template <class T, std::size_t N>
std::string kindText(const T (&values)[N]) {
  return text(std::to_array(values));
}
inline std::string kindText(const Eigen::Quaterniond& value) {
  const std::array<double, 4> all{value.w(), value.x(), value.y(), value.z()};
  return coefficients(all.data(), 4);
}
template <int Mode>
std::string kindText(const Eigen::Transform<double, 3, Mode>& value) {
  const Eigen::Matrix<double, 3, 4> all = value.affine();
  return coefficients(all.data(), all.size());
}

template <class T>
std::string text(const T& value) {
  if constexpr (requires { kindText(value); }) {
    return kindText(value);
  } else if constexpr (std::is_enum_v<T>) {
    return value == T::On ? "On" : "Off";
  } else if constexpr (Number<T>) {
    return number(value);
  } else if constexpr (Coefficients<T>) {
    return coefficients(value.data(), value.size());
  } else if constexpr (Range<T>) {
    return rangeText(value);
  } else if constexpr (Pointer<T>) {
    return value ? text(*value) : "none";
  } else {
    return structText(value);
  }
}

}  // namespace evolution
