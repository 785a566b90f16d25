#pragma once
// This reads a component's parameters from JSON. Generated code calls field() once for each member.

#include <suture/annotate.h>

#include <Eigen/Geometry>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace suture {

/// Says what is wrong in a JSON text, and where: an RFC 6901 pointer, which the deployment turns
/// into file and line.
struct JsonProblem {
  std::string pointer;
  std::string text;
};

/// One thread, and set-up code only, since it allocates. Holds one JSON value that becomes one C++
/// value. It collects all problems instead of stopping at the first. It must not outlive the JSON
/// nor the list of problems that its constructor gets.
class JsonReader {
 public:
  JsonReader(const nlohmann::json& json, std::string pointer, std::vector<JsonProblem>& problems)
      : json_(json), pointer_(std::move(pointer)), problems_(problems) {}

  /// Returns the value that it holds.
  const nlohmann::json& json() const { return json_; }
  /// Reports: "expected a number, found the string \"fast\"".
  void expected(std::string_view what) const;
  /// Reports `text` at the place of this value.
  void report(std::string text) const { problems_.push_back({pointer_, std::move(text)}); }

  /// Reads member `key` of this object into `target`; if it is absent, `target` keeps its default.
  template <class T>
  void field(const char* key, T& target);
  /// Does the same for numbers, which must all lie between `lowest` and `highest`, inclusive. Keys
  /// of maps may be any.
  template <class T>
  void field(const char* key, T& target, double lowest, double highest);
  /// After all fields: reports every key that is not the name of one of them.
  void finish() const;

  /// Returns true if any problem has been reported so far, here or anywhere else in the text.
  bool failed() const { return !problems_.empty(); }

  /// Returns true if this number lies between the two, and reports else that `what` was expected:
  /// "a number".
  bool isWithin(double lowest, double highest, std::string_view what) const;
  /// Reports a time that would be taken for 0, of which the type counts steps of `tick` seconds.
  void tooShort(double tick) const;
  /// Reports every number, here or within lists and objects, that is not between the two.
  void checkRange(double lowest, double highest) const;

  /// Return a reader of a member of this object, or of an element of this list, which must be
  /// there.
  JsonReader at(const std::string& key) const;
  JsonReader at(std::size_t index) const;
  /// Reports and returns true if this value lies deeper than any real one, because types may
  /// contain themselves.
  bool tooDeep() const;
  /// Returns true if this value is a list of `size` elements; reports nothing.
  bool isArrayOf(std::size_t size) const;

 private:
  JsonReader below(const nlohmann::json& json, std::string pointer) const;

  const nlohmann::json& json_;
  std::string pointer_;
  std::vector<JsonProblem>& problems_;
  unsigned depth_ = 0;
  std::vector<std::string> known_;
};

void fromJson(const JsonReader& in, bool& value);
void fromJson(const JsonReader& in, std::string& value);
void fromJson(const JsonReader& in, std::byte& value);
void fromJson(const JsonReader& in, Eigen::Isometry3d& value);
void fromJson(const JsonReader& in, Eigen::Affine3d& value);

/// Returns the index of the enumerator whose name this is, of those in `names`, or reports and
/// returns -1.
int enumeratorFromJson(const JsonReader& in, const std::vector<std::string>& names);

template <class T>
requires(std::is_arithmetic_v<T> && !std::is_same_v<T, bool> &&
         !std::is_same_v<T, char>) void fromJson(const JsonReader& in, T& value) {
  if constexpr (std::is_floating_point_v<T>) {
    if (!in.json().is_number()) return in.expected("a number");
    using Limits = std::numeric_limits<T>;
    const bool fits =
        sizeof(T) >= sizeof(double) || in.isWithin(static_cast<double>(Limits::lowest()),
                                                   static_cast<double>(Limits::max()), "a number");
    if (!fits) return;
    value = in.json().get<T>();
  } else {
    if (!in.json().is_number_integer()) return in.expected("a whole number");
    const bool negative = !in.json().is_number_unsigned();
    const auto fits = negative ? std::in_range<T>(in.json().get<std::int64_t>())
                               : std::in_range<T>(in.json().get<std::uint64_t>());
    if (!fits) {
      return in.expected("a number from " + std::to_string(std::numeric_limits<T>::min()) + " to " +
                         std::to_string(std::numeric_limits<T>::max()));
    }
    value = in.json().get<T>();
  }
}

/// Reads a char of a foreign struct as the number of its byte.
inline void fromJson(const JsonReader& in, char& value) {
  signed char number = 0;
  fromJson(in, number);
  value = static_cast<char>(number);
}

/// Reads durations as numbers of seconds.
template <class Rep, class Period>
void fromJson(const JsonReader& in, std::chrono::duration<Rep, Period>& value) {
  if (!in.json().is_number()) return in.expected("a number of seconds");
  using Target = std::chrono::duration<Rep, Period>;
  using Seconds = std::chrono::duration<double>;
  // Whole seconds, because the most itself is rounded to a double that does not fit.
  const bool fits = in.isWithin(std::ceil(Seconds(Target::min()).count()),
                                std::floor(Seconds(Target::max()).count()), "a number of seconds");
  if (!fits) return;
  const Seconds seconds(in.json().get<double>());
  if constexpr (std::is_floating_point_v<Rep>) {
    value = std::chrono::duration_cast<Target>(seconds);
  } else {
    const auto nearest = std::chrono::round<Target>(seconds);
    // Zero often stands for no limit, so it must be written.
    if (nearest == Target::zero() && seconds != Seconds::zero())
      return in.tooShort(Seconds(Target(1)).count());
    value = nearest;
  }
}

template <class T>
void fromJson(const JsonReader& in, std::vector<T>& value) {
  if (!in.json().is_array()) return in.expected("a list");
  value.resize(in.json().size());
  for (std::size_t i = 0; i < value.size(); ++i) {
    if constexpr (std::is_same_v<T, bool>) {  // the elements of a vector<bool> have no address
      bool element = false;
      fromJson(in.at(i), element);
      value[i] = element;
    } else {
      fromJson(in.at(i), value[i] = T{});
    }
  }
}

template <class T>
void fromJson(const JsonReader& in, std::deque<T>& value) {
  if (!in.json().is_array()) return in.expected("a list");
  value.clear();
  for (std::size_t i = 0; i < in.json().size(); ++i) fromJson(in.at(i), value.emplace_back());
}

template <class T, std::size_t N>
void fromJson(const JsonReader& in, T (&value)[N]) {
  if (!in.isArrayOf(N)) return in.expected("a list of " + std::to_string(N));
  for (std::size_t i = 0; i < N; ++i) fromJson(in.at(i), value[i]);
}

/// Reads a type that has a suture::Wire as that says.
template <class T>
requires requires { typename Wire<T>::Type; }
void fromJson(const JsonReader& in, T& value) {
  typename Wire<T>::Type form = Wire<T>::to(value);
  fromJson(in, form);
  value = Wire<T>::from(form);
}

template <class T, std::size_t N>
void fromJson(const JsonReader& in, std::array<T, N>& value) {
  if (!in.isArrayOf(N)) return in.expected("a list of " + std::to_string(N));
  for (std::size_t i = 0; i < N; ++i) fromJson(in.at(i), value[i]);
}

/// Reads a vector as a list, and a matrix as a list of its rows.
template <class S, int Rows, int Columns, int Options>
requires(Rows > 0 && Columns > 0) void fromJson(const JsonReader& in,
                                                Eigen::Matrix<S, Rows, Columns, Options>& value) {
  if (!in.isArrayOf(Rows)) return in.expected("a list of " + std::to_string(Rows));
  for (int row = 0; row < Rows; ++row) {
    const JsonReader line = in.at(static_cast<std::size_t>(row));
    if constexpr (Columns == 1) {
      fromJson(line, value(row));
    } else {
      if (!line.isArrayOf(Columns)) return line.expected("a list of " + std::to_string(Columns));
      for (int column = 0; column < Columns; ++column) {
        fromJson(line.at(static_cast<std::size_t>(column)), value(row, column));
      }
    }
  }
}

/// Reads a quaternion as the list w, x, y, z.
template <class S>
void fromJson(const JsonReader& in, Eigen::Quaternion<S>& value) {
  std::array<S, 4> wxyz{};
  fromJson(in, wxyz);
  value = Eigen::Quaternion<S>(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
}

/// Judges the numbers of what is read as a T, but not the keys of maps. Whether it is a T at all is
/// told when it is read.
template <class T>
void checkNumbers(const JsonReader& in, std::type_identity<T>, double lowest, double highest) {
  in.checkRange(lowest, highest);
}
template <class T>
void checkElements(const JsonReader& in, double lowest, double highest) {
  if (!in.json().is_array()) return;
  for (std::size_t i = 0; i < in.json().size(); ++i) {
    checkNumbers(in.at(i), std::type_identity<T>(), lowest, highest);
  }
}
template <class T>
void checkNumbers(const JsonReader& in, std::type_identity<std::vector<T>>, double lowest,
                  double highest) {
  checkElements<T>(in, lowest, highest);
}
template <class T>
void checkNumbers(const JsonReader& in, std::type_identity<std::deque<T>>, double lowest,
                  double highest) {
  checkElements<T>(in, lowest, highest);
}
template <class T, std::size_t N>
void checkNumbers(const JsonReader& in, std::type_identity<T[N]>, double lowest, double highest) {
  checkElements<T>(in, lowest, highest);
}
template <class T, std::size_t N>
void checkNumbers(const JsonReader& in, std::type_identity<std::array<T, N>>, double lowest,
                  double highest) {
  checkElements<T>(in, lowest, highest);
}
template <class T>
requires requires { typename Wire<T>::Type; }
void checkNumbers(const JsonReader& in, std::type_identity<T>, double lowest, double highest) {
  checkNumbers(in, std::type_identity<typename Wire<T>::Type>(), lowest, highest);
}

template <class T>
void JsonReader::field(const char* key, T& target) {
  known_.emplace_back(key);
  if (tooDeep()) return;
  if (json_.is_object() && json_.contains(key)) fromJson(at(std::string(key)), target);
}

template <class T>
void JsonReader::field(const char* key, T& target, double lowest, double highest) {
  const std::size_t before = problems_.size();
  if (json_.is_object() && json_.contains(key)) {
    checkNumbers(at(std::string(key)), std::type_identity<T>(), lowest, highest);
  }
  // A value that is judged first needs no copy, which not every type has.
  if (problems_.size() == before) return field(key, target);
  known_.emplace_back(key);
}

}  // namespace suture

#include <suture/component/factory/json_containers.h>
