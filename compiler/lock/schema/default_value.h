#pragma once
// These spell numbers, and what a member is by default, in capnp's own words.

#include <string>

#include "compiler/model/lookup.h"
#include "compiler/model/model.h"

namespace suture::compiler::lock {

/// Returns the shortest spelling that reads back as the same number.
std::string capnpNumber(double value);

/// Returns the member's initialiser. It is empty for anything but numbers, durations and enums,
/// which alone have one on the wire, and for capnp's own zero, which needs no saying.
std::string capnpDefault(const model::Field& field, const model::Lookup& lookup);

}  // namespace suture::compiler::lock
