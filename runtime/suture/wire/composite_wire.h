#pragma once
// These convert between slots and Cap'n Proto for sets, maps, optionals, tuples, variants and
// matrices of any size. See wire.h, which includes this.

#include <suture/wire/wire.h>

namespace suture::rpc {

// --- sets and maps: lists whose elements, or their keys, are all different

template <class List, class Element, std::uint32_t N, class Convert>
Errc fromWireDistinct(const List& in, BoundedList<Element, N>& slot, const Convert& convert) {
  if (const Errc error = fromWireList(in, slot, convert); error != Errc{}) return error;
  return arrange(slot) ? Errc{} : Errc::Invalid;
}

// --- lists of fixed vectors: all coefficients in one flat list

template <Number S, std::size_t R, std::uint32_t N, class List>
void toWireFlat(const BoundedList<std::array<S, R>, N>& slot, List out) {
  std::uint32_t next = 0;
  for (std::uint32_t i = 0; i < out.size() / R; ++i) {
    for (const S coefficient : slot.data[i]) out.set(next++, coefficient);
  }
}
template <class List, Number S, std::size_t R, std::uint32_t N>
Errc fromWireFlat(const List& in, BoundedList<std::array<S, R>, N>& slot) {
  if (in.size() % R != 0) return Errc::Invalid;
  if (!resize(slot, in.size() / R)) return Errc::TooLarge;
  std::uint32_t next = 0;
  for (std::uint32_t i = 0; i < slot.size; ++i) {
    for (S& coefficient : slot.data[i]) coefficient = in[next++];
  }
  return Errc{};
}

// --- matrices of any size

template <Number S, std::uint32_t R, std::uint32_t C, class Builder>
void toWire(const BoundedMatrix<S, R, C>& slot, Builder out) {
  const auto [rows, columns] = extentOf(slot);
  out.setRows(rows);
  out.setColumns(columns);
  const std::uint32_t count = rows * columns;
  if constexpr (std::is_same_v<decltype(out.initData(0)), capnp::Data::Builder>) {  // bulk()
    auto data = out.initData(count * sizeof(S));
    std::copy_n(reinterpret_cast<const kj::byte*>(elements(slot)), data.size(), data.begin());
  } else {
    auto data = out.initData(count);
    for (std::uint32_t i = 0; i < count; ++i) data.set(i, elements(slot)[i]);
  }
}
template <class Reader, Number S, std::uint32_t R, std::uint32_t C>
Errc fromWire(Reader in, BoundedMatrix<S, R, C>& slot) {
  if (!withinBounds<R, C>(in.getRows(), in.getColumns())) return Errc::TooLarge;
  const auto data = in.getData();
  const std::uint64_t count = std::uint64_t{in.getRows()} * in.getColumns();
  constexpr bool bulk = std::is_same_v<decltype(in.getData()), capnp::Data::Reader>;
  if (data.size() != count * (bulk ? sizeof(S) : 1)) return Errc::Invalid;
  if (!resize(slot, in.getRows(), in.getColumns())) return Errc::TooLarge;
  if constexpr (bulk) {
    std::copy_n(data.begin(), data.size(), reinterpret_cast<kj::byte*>(elements(slot)));
  } else {
    for (std::uint32_t i = 0; i < data.size(); ++i) elements(slot)[i] = data[i];
  }
  return Errc{};
}

// --- validity

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
/// Is isValid() as a check that can be passed on.
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

}  // namespace suture::rpc
