#pragma once
// These read sets, maps, optionals, tuples, variants and matrices of any size from JSON. See
// json_reader.h, which includes this.

#include <suture/component/factory/json_reader.h>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <variant>

namespace suture {

/// Reads null as an empty optional. What the JSON does not mention of a value keeps its default.
template <class T>
void fromJson(const JsonReader& in, std::optional<T>& value) {
  if (in.json().is_null()) return value.reset();
  if (!value) value.emplace();
  fromJson(in, *value);
}
template <class T>
void fromJson(const JsonReader& in, std::unique_ptr<T>& value) {
  if (in.json().is_null()) return value.reset();
  if (!value) value = std::make_unique<T>();
  fromJson(in, *value);
}

template <class Set>
void setFromJson(const JsonReader& in, Set& value) {
  if (!in.json().is_array()) return in.expected("a list");
  value.clear();
  for (std::size_t i = 0; i < in.json().size(); ++i) {
    typename Set::key_type element{};
    fromJson(in.at(i), element);
    if (!value.insert(std::move(element)).second) in.at(i).report("this stands twice");
  }
}
template <class T, class Order>
void fromJson(const JsonReader& in, std::set<T, Order>& value) {
  setFromJson(in, value);
}
template <class T>
void fromJson(const JsonReader& in, std::unordered_set<T>& value) {
  setFromJson(in, value);
}

/// Reads an object if the keys are strings, else a list of pairs [key, value].
template <class Map>
void mapFromJson(const JsonReader& in, Map& value) {
  using Key = typename Map::key_type;
  value.clear();
  if constexpr (std::is_same_v<Key, std::string>) {
    if (!in.json().is_object()) return in.expected("an object");
    for (const auto& [key, unused] : in.json().items()) fromJson(in.at(key), value[key]);
  } else {
    if (!in.json().is_array()) return in.expected("a list of pairs");
    for (std::size_t i = 0; i < in.json().size(); ++i) {
      std::pair<Key, typename Map::mapped_type> entry{};
      fromJson(in.at(i), entry);
      if (!value.insert(std::move(entry)).second) in.at(i).report("this key stands twice");
    }
  }
}
template <class Key, class Value, class Order>
void fromJson(const JsonReader& in, std::map<Key, Value, Order>& value) {
  mapFromJson(in, value);
}
template <class Key, class Value>
void fromJson(const JsonReader& in, std::unordered_map<Key, Value>& value) {
  mapFromJson(in, value);
}

template <class Value>
void checkValues(const JsonReader& in, double lowest, double highest) {
  if (in.json().is_object()) {
    for (const auto& [key, unused] : in.json().items()) {
      checkNumbers(in.at(key), std::type_identity<Value>(), lowest, highest);
    }
  } else if (in.json().is_array()) {
    for (std::size_t i = 0; i < in.json().size(); ++i) {
      if (!in.at(i).isArrayOf(2)) continue;
      checkNumbers(in.at(i).at(1), std::type_identity<Value>(), lowest, highest);
    }
  }
}
template <class Key, class Value, class Order>
void checkNumbers(const JsonReader& in, std::type_identity<std::map<Key, Value, Order>>,
                  double lowest, double highest) {
  checkValues<Value>(in, lowest, highest);
}
template <class Key, class Value>
void checkNumbers(const JsonReader& in, std::type_identity<std::unordered_map<Key, Value>>,
                  double lowest, double highest) {
  checkValues<Value>(in, lowest, highest);
}
template <class T>
void checkNumbers(const JsonReader& in, std::type_identity<std::optional<T>>, double lowest,
                  double highest) {
  if (!in.json().is_null()) checkNumbers(in, std::type_identity<T>(), lowest, highest);
}
template <class T>
void checkNumbers(const JsonReader& in, std::type_identity<std::unique_ptr<T>>, double lowest,
                  double highest) {
  if (!in.json().is_null()) checkNumbers(in, std::type_identity<T>(), lowest, highest);
}

/// Reads a list of the members.
template <class Tuple, std::size_t... I>
void tupleFromJson(const JsonReader& in, Tuple& value, std::index_sequence<I...>) {
  if (!in.isArrayOf(sizeof...(I))) {
    return in.expected("a list of " + std::to_string(sizeof...(I)));
  }
  (fromJson(in.at(I), std::get<I>(value)), ...);
}
template <class... T>
void fromJson(const JsonReader& in, std::tuple<T...>& value) {
  tupleFromJson(in, value, std::index_sequence_for<T...>());
}
template <class A, class B>
void fromJson(const JsonReader& in, std::pair<A, B>& value) {
  tupleFromJson(in, value, std::make_index_sequence<2>());
}

inline void fromJson(const JsonReader& in, std::monostate&) {
  if (!in.json().is_null()) in.expected("null");
}

/// Reads {"index": 1, "value": ...}, because two alternatives may read alike and only the index
/// tells which one it is.
template <class Variant, std::size_t... I>
void variantFromJson(const JsonReader& in, Variant& value, std::index_sequence<I...>) {
  JsonReader reader = in;
  std::size_t index = value.index();
  reader.field("index", index, 0, sizeof...(I) - 1);
  const auto read = [&](auto number) {
    if (value.index() != number) value.template emplace<number>();
    reader.field("value", *std::get_if<number>(&value));
  };
  ((I == index ? read(std::integral_constant<std::size_t, I>()) : void()), ...);
  reader.finish();
}
template <class... T>
void fromJson(const JsonReader& in, std::variant<T...>& value) {
  variantFromJson(in, value, std::index_sequence_for<T...>());
}

/// Reads a vector as a list, and a matrix as a list of its rows, all equally long.
template <class S, int Rows, int Columns, int O, int MaxRows, int MaxColumns>
requires(Rows == Eigen::Dynamic || Columns == Eigen::Dynamic) void fromJson(
    const JsonReader& in, Eigen::Matrix<S, Rows, Columns, O, MaxRows, MaxColumns>& value) {
  if constexpr (Rows == 1 || Columns == 1) {
    std::vector<S> coefficients;
    fromJson(in, coefficients);
    value.resize(static_cast<Eigen::Index>(coefficients.size()));
    std::copy(coefficients.begin(), coefficients.end(), value.data());
  } else {
    std::vector<std::vector<S>> rows;
    fromJson(in, rows);
    const std::size_t columns = rows.empty() ? 0 : rows.front().size();
    if (Rows != Eigen::Dynamic && rows.size() != static_cast<std::size_t>(Rows)) {
      return in.expected("a list of " + std::to_string(Rows));
    }
    value.resize(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns));
    for (std::size_t row = 0; row < rows.size(); ++row) {
      if (rows[row].size() != columns) {
        return in.at(row).expected("a list of " + std::to_string(columns));
      }
      for (std::size_t column = 0; column < columns; ++column) {
        value(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
            rows[row][column];
      }
    }
  }
}

}  // namespace suture
