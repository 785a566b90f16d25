#pragma once
// Values as JSON, by their schema.

#include <capnp/dynamic.h>
#include <suture/wire/json/json.h>

namespace suture {

/// How fields are called.
enum class Labels {
  Names,  ///< "position"
  Units,  ///< "position [m]", for people
};

/// Fields by their names in C++; an optional is its value or null; of a union the one that is set.
/// Throws SetupError if it is nested deeper than anything of ours.
Json toJson(capnp::DynamicStruct::Reader value, Labels labels);
/// What the result of a command or the payload of an event carries: its fields, or the one that it
/// has; null if it has none. When it was produced is no part of it.
Json payloadToJson(capnp::DynamicStruct::Reader message, Labels labels);

}  // namespace suture
