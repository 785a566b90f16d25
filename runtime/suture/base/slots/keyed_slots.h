#pragma once
// These are slots of sets and maps: lists in the order of their keys, whatever the order of the
// container, so that equal values are equal bytes. See slots.h, which includes this. Loading does
// not allocate if the std::set or std::map has had as many elements before; the unordered ones may
// allocate.

#include <suture/base/slots/slots.h>

#include <map>
#include <set>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace suture {

template <Number T>
bool comesBefore(T a, T b) {
  return a < b;
}
template <std::uint32_t N>
bool comesBefore(const BoundedText<N>& a, const BoundedText<N>& b) {
  return std::string_view(elements(a), sizeOf(a)) < std::string_view(elements(b), sizeOf(b));
}
template <class Key, class Value>
bool comesBefore(const SlotEntry<Key, Value>& a, const SlotEntry<Key, Value>& b) {
  return comesBefore(a.key, b.key);
}

/// Sorts the first `size` elements. Returns false if two of them, or two of their keys, are equal.
/// It sorts them as a heap, which stays within its places even if another process changes what it
/// compares; std::sort() relies on an element to stop at.
template <class S, std::uint32_t N>
bool arrange(BoundedList<S, N>& slot, std::size_t size) {
  S* const begin = elements(slot);
  S* const end = begin + size;
  const auto before = [](const S& a, const S& b) { return comesBefore(a, b); };
  if (!std::is_sorted(begin, end, before)) {
    std::make_heap(begin, end, before);
    std::sort_heap(begin, end, before);
  }
  return std::adjacent_find(begin, end, [&](const S& a, const S& b) { return !before(a, b); }) ==
         end;
}

template <class Key, class Value, class K, class V>
bool store(const std::pair<const Key, Value>& value, SlotEntry<K, V>& slot) {
  const bool fits = store(value.first, slot.key);
  return store(value.second, slot.value) && fits;
}

/// Stores a set or a map of any kind.
template <class Container, class S, std::uint32_t N>
bool storeKeyed(const Container& value, BoundedList<S, N>& slot) {
  if (!resize(slot, value.size())) return false;
  S* next = elements(slot);
  bool fits = true;
  for (const auto& element : value) fits = store(element, *next++) && fits;
  return fits && arrange(slot, value.size());
}

/// Fills any set or map: calls reuse(element, node) while it has old nodes, and then add(element).
template <class Container, class S, std::uint32_t N, class Reuse, class Add>
void loadKeyed(const BoundedList<S, N>& slot, Container& value, const Reuse& reuse,
               const Add& add) {
  Container old;
  old.swap(value);
  for (std::uint32_t i = 0; i < sizeOf(slot); ++i) {
    if (old.empty()) {
      add(slot.data[i]);
    } else {
      auto node = old.extract(old.begin());
      reuse(slot.data[i], node);
      value.insert(std::move(node));
    }
  }
}

template <class Set, class S, std::uint32_t N>
void loadSet(const BoundedList<S, N>& slot, Set& value) {
  loadKeyed(
      slot, value, [](const S& element, auto& node) { load(element, node.value()); },
      [&](const S& element) {
        typename Set::key_type key{};
        load(element, key);
        value.insert(std::move(key));
      });
}

template <class Map, class S, std::uint32_t N>
void loadMap(const BoundedList<S, N>& slot, Map& value) {
  loadKeyed(
      slot, value,
      [](const S& element, auto& node) {
        load(element.key, node.key());
        load(element.value, node.mapped());
      },
      [&](const S& element) {
        typename Map::key_type key{};
        load(element.key, key);
        load(element.value, value[std::move(key)]);
      });
}

// An order may compare with what is no key as well: std::less<>.
template <class T, class Order, class S, std::uint32_t N>
bool store(const std::set<T, Order>& value, BoundedList<S, N>& slot) {
  return storeKeyed(value, slot);
}
template <class T, class Order, class S, std::uint32_t N>
void load(const BoundedList<S, N>& slot, std::set<T, Order>& value) {
  loadSet(slot, value);
}

template <class T, class S, std::uint32_t N>
bool store(const std::unordered_set<T>& value, BoundedList<S, N>& slot) {
  return storeKeyed(value, slot);
}
template <class T, class S, std::uint32_t N>
void load(const BoundedList<S, N>& slot, std::unordered_set<T>& value) {
  loadSet(slot, value);
}

template <class Key, class Value, class Order, class K, class V, std::uint32_t N>
bool store(const std::map<Key, Value, Order>& value, BoundedList<SlotEntry<K, V>, N>& slot) {
  return storeKeyed(value, slot);
}
template <class Key, class Value, class Order, class K, class V, std::uint32_t N>
void load(const BoundedList<SlotEntry<K, V>, N>& slot, std::map<Key, Value, Order>& value) {
  loadMap(slot, value);
}

template <class Key, class Value, class K, class V, std::uint32_t N>
bool store(const std::unordered_map<Key, Value>& value, BoundedList<SlotEntry<K, V>, N>& slot) {
  return storeKeyed(value, slot);
}
template <class Key, class Value, class K, class V, std::uint32_t N>
void load(const BoundedList<SlotEntry<K, V>, N>& slot, std::unordered_map<Key, Value>& value) {
  loadMap(slot, value);
}

}  // namespace suture
