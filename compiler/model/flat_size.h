#pragma once
// This counts the bytes that a value takes up in its slot.

#include <cstdint>

#include "compiler/model/lookup.h"

namespace suture::compiler::model {

/// Returns the bytes of the type's flat form without padding, and saturates. Unbounded levels count
/// as empty. The type must be free of recursion.
std::uint64_t flatSize(const Type& type, const Lookup& lookup);

}  // namespace suture::compiler::model
