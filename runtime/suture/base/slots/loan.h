#pragma once
// A component writes a list of numbers here straight into the slot from which it leaves.

#include <suture/base/slots/slot_forms.h>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace suture {

/// Returns the member of a slot that has only one, such as that of the arguments of a command with
/// one argument.
template <class Slot>
auto& onlyMember(Slot& slot) {
  auto& [member] = slot;
  return member;
}

/// Returns the list that `List` names in `slot`: one pointer to a member, or several that lead
/// through the slots between.
///   listIn<&StereoPairSlot::left, &ImageFrameSlot::data>(slot)
template <auto... List, class Slot>
auto& listIn(Slot& slot) {
  static_assert(sizeof...(List) > 0, "name the list, such as loan<&PictureSlot::pixels>(...)");
  return (slot.*....*List);
}

/// `fill(std::span<Element>)` writes `list`: it gets all the room that there is, and returns how
/// many elements it has written. Returns false if it says more than there is room for.
template <class Element, std::uint32_t N, class Fill>
bool fillList(BoundedList<Element, N>& list, const Fill& fill) {
  static_assert(std::is_arithmetic_v<Element> && N != kUnbounded,
                "only a list of numbers that has a capacity() can be filled on loan");
  static_assert(std::is_invocable_r_v<std::size_t, const Fill&, std::span<Element>>,
                "what fills the list takes a std::span of it and returns how many it has written");
  return resize(list, fill(std::span<Element>(list.data)));
}

}  // namespace suture
