#pragma once
// These are the names that generated code declares in the user's namespace, so that nothing else
// may have them.

#include "compiler/frontend/types/mapping.h"
#include "compiler/model/model.h"

namespace suture::compiler::frontend {

/// Reports what the namespaces of our headers hold under such a name.
void checkGeneratedNames(const model::Model& model, Mapping& mapping);

}  // namespace suture::compiler::frontend
