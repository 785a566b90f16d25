#pragma once
// Values of a schema that was learnt at run time.

#include <capnp/dynamic.h>
#include "cli/values/json.h"

namespace suture::cli {

/// How fields are called.
enum class Labels {
  Names,  ///< "position"
  Units,  ///< "position [m]", for people
};

/// Fields by their names in C++; an optional is its value or null; of a union the one that is set.
/// Throws SetupError if it is nested deeper than anything of ours.
Json toJson(capnp::DynamicStruct::Reader value, Labels labels);

}  // namespace suture::cli
