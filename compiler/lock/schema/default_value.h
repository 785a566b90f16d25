#pragma once
// A schema spells numbers, and what a member is by default, in capnp's own words.

#include <string>

#include "compiler/model/lookup.h"
#include "compiler/model/model.h"

namespace suture::compiler::lock {

/// The shortest spelling that reads back as the same number.
std::string capnpNumber(double value);

/// The member's initialiser. Only numbers, durations and enums have one on the wire, and capnp's
/// own zero needs no saying: it is empty for all else.
std::string capnpDefault(const model::Field& field, const model::Lookup& lookup);

}  // namespace suture::compiler::lock
