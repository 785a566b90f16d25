#pragma once
// This walks through everything that a type holds, into the structs that it names.

#include <functional>
#include <string>

#include "compiler/model/lookup.h"

namespace suture::compiler::check {

/// This is one place within a type: how to get there ("position[].x") and the field that declares
/// it, which is null for the type itself.
struct Place {
  const model::Type& type;
  std::string path;
  const model::Field* field;
  bool recursive = false;  ///< a struct that holds this place; it is not entered again
};

/// Tells if this level of the type can have any size, so that it needs a capacity().
bool isSized(const model::Type& type);

/// Tells if this level lacks the capacity() that it needs. A capacity of zero is none.
bool isOpen(const model::Type& type);

/// Calls `visit` for the type and all it holds, outside in, until `visit` returns false; then
/// walk() returns false itself. It enters each struct by the first way there, since what that holds
/// is the same by any other.
bool walk(const model::Type& type, const model::Lookup& lookup,
          const std::function<bool(const Place&)>& visit);

/// Tells if a value of the type owns memory on the heap.
bool ownsHeap(const model::Type& type, const model::Lookup& lookup);

}  // namespace suture::compiler::check
