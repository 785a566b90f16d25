#pragma once
// These access fields of packed structs. No reference binds to one, so each is copied to where its
// type is aligned, and back.

#include <cstring>
#include <type_traits>

namespace suture {

/// Holds a copy of a packed field, which may be an array.
template <class Field>
struct Unpacked {
  Field value;
};

/// Returns a copy of the field.
template <class Struct, class Field>
Unpacked<Field> unpacked(const Struct& owner, Field Struct::*field) {
  static_assert(std::is_trivially_copyable_v<Field>);
  Unpacked<Field> copy;
  std::memcpy(static_cast<void*>(&copy), &(owner.*field), sizeof(Field));
  return copy;
}

/// Calls `change` with a copy of the field, and writes the copy back.
template <class Struct, class Field, class Change>
void changePacked(Struct& owner, Field Struct::*field, const Change& change) {
  Unpacked<Field> copy = unpacked(owner, field);
  change(copy.value);
  std::memcpy(static_cast<void*>(&(owner.*field)), &copy, sizeof(Field));
}

}  // namespace suture
