#pragma once
// These are the names that generated code declares in the user's namespace, so that nothing else
// may have them.

#include "compiler/frontend/types/mapping.h"

namespace suture::compiler::frontend {

/// Reports what the namespace of an annotated declaration holds under such a name.
void checkGeneratedNames(const clang::TagDecl* declaration, Kind kind, Mapping& mapping);

}  // namespace suture::compiler::frontend
