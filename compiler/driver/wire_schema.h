#pragma once
// This is the schema that a build compiles for a header.

#include "compiler/lock/schema/lock.h"
#include "compiler/model/artefact.h"
#include "compiler/model/model.h"

namespace suture::compiler::driver {

/// Returns "arm/arm.capnp": the header's lock word for word, so that the build compiles what was
/// checked; an empty schema for a header that declares nothing for a wire, so that all headers
/// build alike.
model::Artefact wireSchema(const model::Header& header, const lock::Locks& locks);

}  // namespace suture::compiler::driver
