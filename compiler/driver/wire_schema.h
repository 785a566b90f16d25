#pragma once
// This is the schema that a build compiles for a header.

#include "compiler/lock/schema/lock.h"
#include "compiler/model/artefact.h"
#include "compiler/model/model.h"

namespace suture::compiler::driver {

/// Returns the schema "arm/arm.capnp" that the build compiles. It is the header's lock word for
/// word, so that what is compiled is what was checked. A header that declares nothing for a wire
/// gets an empty schema, because the build expects one of every header.
model::Artefact wireSchema(const model::Header& header, const lock::Locks& locks);

}  // namespace suture::compiler::driver
