#pragma once
// Arguments for a schema that was learnt at run time.

#include <capnp/dynamic.h>
#include "cli/values/json.h"

#include <string>

namespace suture::cli {

/// Sets all fields of `out` but capabilities and those of the runtime itself. The reverse of
/// toJson(), and strict: a robot is not sent zeros that nobody wrote. Throws UsageError: a field is
/// missing, unknown or of another type.
void fill(capnp::DynamicStruct::Builder out, const Json& json, const std::string& path);

}  // namespace suture::cli
