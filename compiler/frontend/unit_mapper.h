#pragma once
// From the tree of a whole translation unit to the model.

#include "compiler/frontend/annotation_uses.h"
#include "compiler/frontend/header_table.h"
#include "compiler/frontend/mapping.h"

namespace suture::compiler::frontend {

/// Maps every annotated declaration, own and foreign. Each either enters the model or is an error.
model::Model mapUnit(clang::ASTContext& context, HeaderTable& headers, SourceTable& table,
                     AnnotationUses& uses, model::Diagnostics& findings);

}  // namespace suture::compiler::frontend
