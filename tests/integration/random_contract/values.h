#pragma once
// These make random values of every kind of member that a type may have, and compare them.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

namespace invented {

/// This is a type of ours, so that the functions below are found by their argument whatever they
/// fill.
struct Random : std::mt19937_64 {
  /// Says how many elements containers get; with Beyond the first one gets one more than it may
  /// have, all others what they may.
  enum class Length { Any, Empty, Full, Beyond };

  explicit Random(std::uint64_t seed) : std::mt19937_64(seed) {}

  /// Marks a bound that no capacity() states: what is there fits, however much it is.
  static constexpr unsigned kOpen = 1u << 16;

  std::size_t count(unsigned stated) {
    const unsigned bound = stated % kOpen;
    switch (length) {
      case Length::Empty: return 0;
      case Length::Full: return bound;
      case Length::Beyond:
        if (stated != bound) return 2 * bound;
        length = Length::Full;
        return bound + 1;
      case Length::Any: break;
    }
    return (*this)() % (bound + 1);
  }
  bool isPresent() { return length == Length::Any ? (*this)() % 2 == 0 : length != Length::Empty; }

  /// Runs `fill` for a value that will not be used.
  template <class Fill>
  void aside(const Fill& fill) {
    const Length before = std::exchange(length, Length::Empty);
    fill();
    length = before;
  }

  int depth = 0;  // how deep structs hold themselves
  Length length = Length::Any;
  bool finite = true;  // NaN and infinity are real numbers that no provider takes
};
struct Tag {};

/// Bounds how deep a struct that holds itself is filled.
class Descent {
 public:
  explicit Descent(Random& random) : random_(random) { ++random_.depth; }
  ~Descent() { --random_.depth; }
  Descent(const Descent&) = delete;
  Descent& operator=(const Descent&) = delete;
  bool goesOn() const { return random_.depth < 4; }

 private:
  Random& random_;
};

/// These are the capacities of a member, from outside to inside; each level takes its own.
using Bounds = const unsigned*;

template <class T>
requires std::is_arithmetic_v<T>
void fill(T& value, Random& random, Bounds&) {
  if constexpr (std::is_same_v<T, bool>) {
    value = random() % 2 == 0;
  } else if constexpr (std::is_floating_point_v<T>) {
    using Limits = std::numeric_limits<T>;
    constexpr T kOdd[] = {-T{0},
                          Limits::denorm_min(),
                          Limits::max(),
                          Limits::lowest(),
                          Limits::quiet_NaN(),
                          -Limits::infinity()};
    const auto choice = random() % 12;
    value = choice < (random.finite ? 4 : 6)
                ? kOdd[choice]
                : static_cast<T>(std::normal_distribution<double>(0, 1e3)(random));
  } else {
    value = static_cast<T>(random());
  }
}
/// Bit for bit: -0 is not 0.
template <class T>
requires std::is_arithmetic_v<T>
bool equal(const T& a, const T& b, Tag) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// Takes real numbers, and those in a list, into their range; NaN stays.
template <class T>
void keepWithin(T& value, double least, double most) {
  if constexpr (std::is_arithmetic_v<T>) {
    if (static_cast<double>(value) < least) value = static_cast<T>(least);
    if (static_cast<double>(value) > most) value = static_cast<T>(most);
  } else {
    for (auto& element : value) keepWithin(element, least, most);
  }
}

template <class E>
requires std::is_enum_v<E>
void fill(E& value, Random& random, Bounds&) {
  if constexpr (std::is_same_v<E, std::byte>) {
    value = static_cast<std::byte>(random() % 256);
  } else {
    constexpr std::array<E, 3> kAll{E::First, E::Second, E::Third};
    value = kAll[random() % 3];
  }
}
template <class E>
requires std::is_enum_v<E>
bool equal(E a, E b, Tag) { return a == b; }

inline void fill(std::monostate&, Random&, Bounds&) {}
inline bool equal(std::monostate, std::monostate, Tag) { return true; }

inline void fill(std::string& value, Random& random, Bounds& bounds) {
  value.resize(random.count(*bounds++));
  for (char& c : value) c = static_cast<char>(' ' + random() % 95);
}
inline bool equal(const std::string& a, const std::string& b, Tag) { return a == b; }

template <class Rep, class Period>
void fill(std::chrono::duration<Rep, Period>& value, Random& random, Bounds&) {
  // The value is less than half a year, so that it fits in nanoseconds, and whole milliseconds, so
  // that nothing is rounded.
  value = std::chrono::duration_cast<std::chrono::duration<Rep, Period>>(
      std::chrono::milliseconds(static_cast<std::int64_t>(random() % 10'000'000'000)));
}
template <class Rep, class Period>
bool equal(std::chrono::duration<Rep, Period> a, std::chrono::duration<Rep, Period> b, Tag) {
  return a == b;
}
template <class Clock, class D>
void fill(std::chrono::time_point<Clock, D>& value, Random& random, Bounds& bounds) {
  D since;
  fill(since, random, bounds);
  value = std::chrono::time_point<Clock, D>(since);
}
template <class Clock, class D>
bool equal(std::chrono::time_point<Clock, D> a, std::chrono::time_point<Clock, D> b, Tag) {
  return a == b;
}

template <class S, int Rows, int Columns>
void fill(Eigen::Matrix<S, Rows, Columns>& value, Random& random, Bounds& bounds) {
  if constexpr (Rows == Eigen::Dynamic && Columns == Eigen::Dynamic) {
    const auto rows = static_cast<Eigen::Index>(random.count(*bounds++));
    value.resize(rows, static_cast<Eigen::Index>(random.count(*bounds++)));
  } else if constexpr (Rows == Eigen::Dynamic) {
    value.resize(static_cast<Eigen::Index>(random.count(*bounds++)));
  } else if constexpr (Columns == Eigen::Dynamic) {
    value.resize(Rows, static_cast<Eigen::Index>(random.count(*bounds++)));
  }
  for (Eigen::Index i = 0; i < value.size(); ++i) fill(value.data()[i], random, bounds);
}
template <class S, int Rows, int Columns>
bool equal(const Eigen::Matrix<S, Rows, Columns>& a, const Eigen::Matrix<S, Rows, Columns>& b,
           Tag tag) {
  return a.rows() == b.rows() && a.cols() == b.cols() &&
         std::equal(a.data(), a.data() + a.size(), b.data(),
                    [tag](S x, S y) { return equal(x, y, tag); });
}
inline void fill(Eigen::Quaterniond& value, Random& random, Bounds& bounds) {
  fill(value.coeffs(), random, bounds);
}
inline bool equal(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b, Tag tag) {
  return equal(a.coeffs(), b.coeffs(), tag);
}
template <int Mode>
void fill(Eigen::Transform<double, 3, Mode>& value, Random& random, Bounds& bounds) {
  Eigen::Matrix3d linear;
  Eigen::Vector3d translation;
  fill(linear, random, bounds);
  fill(translation, random, bounds);
  if (linear.col(0).isZero(0)) linear(0, 0) = 1;  // no rotation has a column of zeros
  value.linear() = linear;
  value.translation() = translation;
}
template <int Mode>
bool equal(const Eigen::Transform<double, 3, Mode>& a, const Eigen::Transform<double, 3, Mode>& b,
           Tag tag) {
  return equal(a.matrix(), b.matrix(), tag);
}

/// Fills elements that all have the bounds that follow; `add(element)` is called once for each.
template <class T, class Add>
void fillElements(std::size_t count, Random& random, Bounds& bounds, const Add& add) {
  Bounds end = bounds;
  T unused{};
  random.aside([&] { fill(unused, random, end); });
  for (std::size_t i = 0; i < count; ++i) {
    T element{};
    Bounds own = bounds;
    fill(element, random, own);
    add(i, std::move(element));
  }
  bounds = end;
}

template <class T, std::size_t N>
void fill(std::array<T, N>& value, Random& random, Bounds& bounds) {
  fillElements<T>(N, random, bounds,
                  [&](std::size_t i, T&& element) { value[i] = std::move(element); });
}
template <class T, std::size_t N>
bool equal(const std::array<T, N>& a, const std::array<T, N>& b, Tag tag) {
  return std::equal(a.begin(), a.end(), b.begin(),
                    [tag](const T& x, const T& y) { return equal(x, y, tag); });
}
template <class T, std::size_t N>
void fill(T (&value)[N], Random& random, Bounds& bounds) {
  fillElements<T>(N, random, bounds,
                  [&](std::size_t i, T&& element) { value[i] = std::move(element); });
}
template <class T, std::size_t N>
bool equal(const T (&a)[N], const T (&b)[N], Tag tag) {
  return std::equal(a, a + N, b, [tag](const T& x, const T& y) { return equal(x, y, tag); });
}

template <class T>
concept Sequence = std::is_same_v<T, std::vector<typename T::value_type>> ||
    std::is_same_v<T, std::deque<typename T::value_type>>;

template <Sequence T>
void fill(T& value, Random& random, Bounds& bounds) {
  using Element = typename T::value_type;
  const std::size_t count = random.count(*bounds++);
  T filled(count);  // a vector of what has no copy may not compile if it grows
  fillElements<Element>(count, random, bounds,
                        [&](std::size_t i, Element&& element) { filled[i] = std::move(element); });
  value = std::move(filled);
}
template <Sequence T>
bool equal(const T& a, const T& b, Tag tag) {
  const auto same = [tag](const typename T::value_type& x, const typename T::value_type& y) {
    return equal(x, y, tag);
  };
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), same);
}

/// Fills what has keys, of which no two are equal.
template <class Element, class T>
void fillDistinct(T& value, Random& random, Bounds& bounds) {
  value.clear();
  const std::size_t count = random.count(*bounds++);
  Bounds end = bounds;
  Element unused{};
  random.aside([&] { fill(unused, random, end); });
  while (value.size() < count) {
    Element element{};
    Bounds own = bounds;
    fill(element, random, own);
    value.insert(std::move(element));
  }
  bounds = end;
}

template <class T>
concept Set = std::is_same_v<T, std::set<typename T::key_type>> ||
    std::is_same_v<T, std::unordered_set<typename T::key_type>>;

template <Set T>
void fill(T& value, Random& random, Bounds& bounds) {
  fillDistinct<typename T::key_type>(value, random, bounds);
}
template <Set T>
bool equal(const T& a, const T& b, Tag) {
  return a == b;
}

template <class T>
concept Map = std::is_same_v<T, std::map<typename T::key_type, typename T::mapped_type>> ||
    std::is_same_v<T, std::unordered_map<typename T::key_type, typename T::mapped_type>>;

template <Map T>
void fill(T& value, Random& random, Bounds& bounds) {
  fillDistinct<std::pair<typename T::key_type, typename T::mapped_type>>(value, random, bounds);
}
template <Map T>
bool equal(const T& a, const T& b, Tag tag) {
  return a.size() == b.size() && std::all_of(a.begin(), a.end(), [&](const auto& entry) {
           const auto other = b.find(entry.first);
           return other != b.end() && equal(entry.second, other->second, tag);
         });
}

template <class T>
void fill(std::optional<T>& value, Random& random, Bounds& bounds) {
  value.reset();
  fillElements<T>(random.isPresent() ? 1 : 0, random, bounds,
                  [&](std::size_t, T&& element) { value = std::move(element); });
}
template <class T>
bool equal(const std::optional<T>& a, const std::optional<T>& b, Tag tag) {
  return a.has_value() == b.has_value() && (!a || equal(*a, *b, tag));
}

template <class T>
void fill(std::unique_ptr<T>& value, Random& random, Bounds& bounds) {
  value.reset();
  fillElements<T>(random.isPresent() ? 1 : 0, random, bounds, [&](std::size_t, T&& element) {
    value = std::make_unique<T>(std::move(element));
  });
}
template <class T>
bool equal(const std::unique_ptr<T>& a, const std::unique_ptr<T>& b, Tag tag) {
  return (a == nullptr) == (b == nullptr) && (!a || equal(*a, *b, tag));
}

template <class A, class B>
void fill(std::pair<A, B>& value, Random& random, Bounds& bounds) {
  fill(value.first, random, bounds);
  fill(value.second, random, bounds);
}
template <class A, class B>
bool equal(const std::pair<A, B>& a, const std::pair<A, B>& b, Tag tag) {
  return equal(a.first, b.first, tag) && equal(a.second, b.second, tag);
}
template <class... T>
void fill(std::tuple<T...>& value, Random& random, Bounds& bounds) {
  std::apply([&](T&... items) { (fill(items, random, bounds), ...); }, value);
}
template <class... T, std::size_t... I>
bool equalItems(const std::tuple<T...>& a, const std::tuple<T...>& b, std::index_sequence<I...>) {
  return (equal(std::get<I>(a), std::get<I>(b), Tag()) && ...);
}
template <class... T>
bool equal(const std::tuple<T...>& a, const std::tuple<T...>& b, Tag) {
  return equalItems(a, b, std::index_sequence_for<T...>());
}

template <class... T, std::size_t... I>
void fillVariant(std::variant<T...>& value, Random& random, Bounds& bounds,
                 std::index_sequence<I...>) {
  const std::size_t chosen = random() % sizeof...(T);
  const auto fillOne = [&](auto index, auto element) {
    if (index == chosen) {
      fill(element, random, bounds);
      value.template emplace<index>(std::move(element));
    } else {
      random.aside([&] { fill(element, random, bounds); });
    }
  };
  (fillOne(std::integral_constant<std::size_t, I>(), T{}), ...);
}
template <class... T>
void fill(std::variant<T...>& value, Random& random, Bounds& bounds) {
  fillVariant(value, random, bounds, std::index_sequence_for<T...>());
}
template <class... T, std::size_t... I>
bool equalAlternatives(const std::variant<T...>& a, const std::variant<T...>& b,
                       std::index_sequence<I...>) {
  return a.index() == b.index() &&
         ((a.index() != I || equal(*std::get_if<I>(&a), *std::get_if<I>(&b), Tag())) && ...);
}
template <class... T>
bool equal(const std::variant<T...>& a, const std::variant<T...>& b, Tag) {
  return equalAlternatives(a, b, std::index_sequence_for<T...>());
}

}  // namespace invented
