#pragma once
// This is a struct as the list of its members, so that it is filled and compared like a tuple. Each
// type says fields(value, Tag()), whose members list() holds.

#include "values.h"

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

namespace invented {

template <class T, class U>
concept As = std::same_as<std::remove_const_t<T>, U>;

/// This is a member that has capacity(bounds...).
template <class T>
struct Bounded {
  T& value;
  std::array<unsigned, 4> bounds;
};
template <class T, std::convertible_to<unsigned>... B>
Bounded<T> bounded(T& value, B... bounds) {
  return {value, {static_cast<unsigned>(bounds)...}};
}

/// This member has numbers with range(lowest, highest), either of which may be infinite.
template <class T>
struct Ranged {
  T& value;
  double lowest, highest;
};
template <class T>
Ranged<T> ranged(T& value, double lowest, double highest) {
  return {value, lowest, highest};
}

/// References stay references; Bounded and Ranged are kept.
template <class... M>
std::tuple<M...> list(M&&... members) {
  return std::tuple<M...>(std::forward<M>(members)...);
}

inline void fillWithin(double& value, double lowest, double highest, Random& random) {
  constexpr double kGreatest = 1e6;
  const double from = std::max(lowest, -kGreatest), to = std::min(highest, kGreatest);
  switch (random() % 8) {
    case 0: value = lowest; return;
    case 1: value = highest; return;
    case 2:
      if (!random.finite) {
        value = std::numeric_limits<double>::quiet_NaN();
        return;
      }
      [[fallthrough]];
    default: value = std::uniform_real_distribution<double>(from, to)(random);
  }
}
template <std::size_t N>
void fillWithin(std::array<double, N>& values, double lowest, double highest, Random& random) {
  for (double& value : values) fillWithin(value, lowest, highest, random);
}

template <class T>
void fillMember(T& value, Random& random) {
  constexpr unsigned none[] = {0};
  Bounds bounds = none;
  fill(value, random, bounds);
}
template <class T>
void fillMember(Bounded<T>& member, Random& random) {
  Bounds bounds = member.bounds.data();
  fill(member.value, random, bounds);
}
template <class T>
void fillMember(Ranged<T>& member, Random& random) {
  fillWithin(member.value, member.lowest, member.highest, random);
}

template <class T>
const T& valueOf(const T& member) {
  return member;
}
template <class T>
const T& valueOf(const Bounded<T>& member) {
  return member.value;
}
template <class T>
const T& valueOf(const Ranged<T>& member) {
  return member.value;
}

template <class T>
concept Listed = requires(T& value) {
  fields(value, Tag());
};

template <Listed T>
void fill(T& value, Random& random, Bounds&) {
  auto members = fields(value, Tag());
  std::apply([&](auto&... member) { (fillMember(member, random), ...); }, members);
}

template <class A, class B, std::size_t... I>
bool equalMembers(const A& a, const B& b, std::index_sequence<I...>) {
  return (equal(valueOf(std::get<I>(a)), valueOf(std::get<I>(b)), Tag()) && ...);
}
template <Listed T>
bool equal(const T& a, const T& b, Tag) {
  const auto left = fields(a, Tag()), right = fields(b, Tag());
  return equalMembers(left, right, std::make_index_sequence<std::tuple_size_v<decltype(left)>>());
}

/// A foreign enum has no First, so this picks from all of its values.
template <class E>
void pick(E& value, Random& random, std::initializer_list<E> all) {
  value = all.begin()[random() % all.size()];
}

// round_trip.h asks for these.
template <class T>
void fill(T& value, Random& random) {
  fillMember(value, random);
}
template <class T>
bool same(const T& a, const T& b) {
  return equal(a, b, Tag());
}

}  // namespace invented
