#pragma once
// This emits the entry point through which a deployment finds the components of a shared library.

#include <string>

#include "compiler/model/artefact.h"
#include "compiler/model/model.h"

namespace suture::compiler::emit {

/// Emits the source file `path`: suture_components(), which lists every component of the own
/// headers. The list is read, so that no objects have to register themselves when the library is
/// loaded.
model::Artefact emitComponentLibrary(const model::Model& model, const std::string& target,
                                     const std::string& path);

}  // namespace suture::compiler::emit
