#pragma once
// This turns JSON into arguments by a schema that was learnt at run time.

#include <capnp/dynamic.h>
#include "cli/values/json.h"

#include <string>
#include <string_view>

namespace suture::cli {

/// Sets all fields of `out` except capabilities and those of the runtime itself. It reverses
/// toJson(), and is strict: no robot gets zeros that the user did not write. Throws UsageError if a
/// field is missing, unknown or of another type.
void fill(capnp::DynamicStruct::Builder out, const Json& json, const std::string& path);

/// Returns true if `path`, such as "goal.label", leads to a text, or to an optional text for which
/// `value` is not null.
bool leadsToText(capnp::StructSchema schema, std::string_view path, const Json& value);

}  // namespace suture::cli
