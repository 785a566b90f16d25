#pragma once
// These are slots of optionals, tuples and variants. See slots.h, which includes this.

#include <suture/base/slots/slots.h>

#include <cstddef>
#include <memory>
#include <new>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>

namespace suture {

inline bool store(std::monostate, SlotNothing&) { return true; }
inline void load(SlotNothing, std::monostate&) {}

/// Calls `emplace` with what it needs to make a T. Clang finds that a struct is not
/// default-constructible if it has default member initialisers and is nested in the struct that
/// holds it: such a T is moved into place.
template <class T, class Emplace>
void emplaceNew(const Emplace& emplace) {
  if constexpr (std::is_default_constructible_v<T>) {
    emplace();
  } else {
    emplace(T());
  }
}

/// Makes the slot hold a value, and returns it for the caller to fill.
template <class S>
S& engage(OpenOptional<S>& slot) {
  slot.present = 1;
  if (!slot.value) slot.value = std::make_unique<S>();
  return *slot.value;
}

template <class T, class S>
bool store(const std::optional<T>& value, SlotOptional<S>& slot) {
  slot.present = value ? 1 : 0;
  return !value || store(*value, slot.value);
}
template <class T, class S>
void load(const SlotOptional<S>& slot, std::optional<T>& value) {
  if (slot.present == 0) return value.reset();
  if (!value) emplaceNew<T>([&](auto&&... made) { value.emplace(std::move(made)...); });
  load(slot.value, *value);
}

template <class T, class S>
bool store(const std::unique_ptr<T>& value, SlotOptional<S>& slot) {
  slot.present = value ? 1 : 0;
  return !value || store(*value, slot.value);
}
template <class T, class S>
void load(const SlotOptional<S>& slot, std::unique_ptr<T>& value) {
  if (slot.present == 0) return value.reset();
  if (!value) value = std::make_unique<T>();
  load(slot.value, *value);
}

template <class T, class S>
bool store(const std::unique_ptr<T>& value, OpenOptional<S>& slot) {
  return !value ? (slot.present = 0, true) : store(*value, engage(slot));
}
template <class T, class S>
void load(const OpenOptional<S>& slot, std::unique_ptr<T>& value) {
  if (slot.present == 0) return value.reset();
  if (!value) value = std::make_unique<T>();
  load(*slot.value, *value);
}

template <class T, class S>
bool store(const std::optional<T>& value, OpenOptional<S>& slot) {
  return !value ? (slot.present = 0, true) : store(*value, engage(slot));
}
template <class T, class S>
void load(const OpenOptional<S>& slot, std::optional<T>& value) {
  if (slot.present == 0) return value.reset();
  if (!value) emplaceNew<T>([&](auto&&... made) { value.emplace(std::move(made)...); });
  load(*slot.value, *value);
}

template <std::size_t I, class Tuple>
auto& item(Tuple& slot) {
  if constexpr (I == 0) {
    return slot.head;
  } else {
    return item<I - 1>(slot.tail);
  }
}

/// Stores a tuple or a pair, member by member.
template <class Tuple, class Slot, std::size_t... I>
bool storeItems(const Tuple& value, Slot& slot, std::index_sequence<I...>) {
  bool fits = true;
  ((fits = store(std::get<I>(value), item<I>(slot)) && fits), ...);
  return fits;
}
template <class Tuple, class Slot, std::size_t... I>
void loadItems(const Slot& slot, Tuple& value, std::index_sequence<I...>) {
  (load(item<I>(slot), std::get<I>(value)), ...);
}

template <class... T, class... S>
bool store(const std::tuple<T...>& value, SlotTuple<S...>& slot) {
  return storeItems(value, slot, std::index_sequence_for<T...>());
}
template <class... T, class... S>
void load(const SlotTuple<S...>& slot, std::tuple<T...>& value) {
  loadItems(slot, value, std::index_sequence_for<T...>());
}
template <class A, class B, class... S>
bool store(const std::pair<A, B>& value, SlotTuple<S...>& slot) {
  return storeItems(value, slot, std::make_index_sequence<2>());
}
template <class A, class B, class... S>
void load(const SlotTuple<S...>& slot, std::pair<A, B>& value) {
  loadItems(slot, value, std::make_index_sequence<2>());
}

template <std::size_t I, class... S>
auto& alternative(SlotVariant<S...>& slot) {
  if constexpr ((std::is_trivially_copyable_v<S> && ...)) {
    return *std::launder(reinterpret_cast<std::tuple_element_t<I, std::tuple<S...>>*>(slot.data));
  } else {
    return item<I>(slot.all);
  }
}
template <std::size_t I, class... S>
const auto& alternative(const SlotVariant<S...>& slot) {
  return alternative<I>(const_cast<SlotVariant<S...>&>(slot));
}

template <class Variant, class Slot, std::size_t... I>
bool storeAlternative(const Variant& value, Slot& slot, std::index_sequence<I...>) {
  bool fits = false;  // stays false for a variant that lost its value to an exception
  slot.index = static_cast<std::uint32_t>(value.index());
  ((I == value.index() && (fits = store(*std::get_if<I>(&value), alternative<I>(slot)))), ...);
  return fits;
}
template <std::size_t I, class Slot, class Variant>
void loadAlternative(const Slot& slot, Variant& value) {
  if (value.index() != I) {
    emplaceNew<std::variant_alternative_t<I, Variant>>(
        [&](auto&&... made) { value.template emplace<I>(std::move(made)...); });
  }
  load(alternative<I>(slot), *std::get_if<I>(&value));
}
template <class Variant, class Slot, std::size_t... I>
void loadAlternatives(const Slot& slot, Variant& value, std::index_sequence<I...>) {
  ((I == slot.index ? loadAlternative<I>(slot, value) : void()), ...);
}

template <class... T, class... S>
bool store(const std::variant<T...>& value, SlotVariant<S...>& slot) {
  return storeAlternative(value, slot, std::index_sequence_for<T...>());
}
template <class... T, class... S>
void load(const SlotVariant<S...>& slot, std::variant<T...>& value) {
  loadAlternatives(slot, value, std::index_sequence_for<T...>());
}

}  // namespace suture
