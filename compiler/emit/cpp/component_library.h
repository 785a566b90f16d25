#pragma once
// The entry point through which a deployment finds the components of a shared library.

#include <string>

#include "compiler/model/artefact.h"
#include "compiler/model/model.h"

namespace suture::compiler::emit {

/// The source file `path`: suture_components(), which lists every component of the own headers. A
/// list that is read, instead of objects that register themselves when the library is loaded.
model::Artefact emitComponentLibrary(const model::Model& model, const std::string& target,
                                     const std::string& path);

}  // namespace suture::compiler::emit
