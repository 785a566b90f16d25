#pragma once
// This reads the subset of capnp's language that a lock is written in.

#include <string>
#include <string_view>

#include "compiler/lock/schema/lock.h"

namespace suture::compiler::lock {

/// Returns the lock, or throws SyntaxError. It refuses also what capnp itself would: gaps and
/// repeats among ordinals, equal names.
Lock parse(std::string path, std::string_view text);

}  // namespace suture::compiler::lock
