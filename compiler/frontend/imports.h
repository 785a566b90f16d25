#pragma once
// This finds which headers of the model use declarations of which others.

#include "compiler/model/model.h"

namespace suture::compiler::frontend {

/// Fills Header::imports of all headers.
void addImports(model::Model& model);

}  // namespace suture::compiler::frontend
