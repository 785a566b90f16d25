#pragma once
// This shows values as JSON, by their schema.

#include <capnp/dynamic.h>
#include <suture/codec/json/json.h>

namespace suture::codec {

/// Says how fields are called.
enum class Labels {
  Names,  ///< "position"
  Units,  ///< "position [m]", for people
};

/// Returns fields by their names in C++; an optional is its value or null; a union is the field
/// that is set. Throws SetupError if it is nested deeper than anything of ours.
Json toJson(capnp::DynamicStruct::Reader value, Labels labels);
/// Returns what the result of a command or the payload of an event carries: its fields, or the only
/// one that it has; null if it has none. The stamp is no part of it.
Json payloadToJson(capnp::DynamicStruct::Reader message, Labels labels);

}  // namespace suture::codec
