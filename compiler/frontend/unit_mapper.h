#pragma once
// This leads from the tree of a whole translation unit to the model.

#include <clang/Sema/Sema.h>

#include "compiler/frontend/ast/annotation_uses.h"
#include "compiler/frontend/ast/header_table.h"
#include "compiler/frontend/types/mapping.h"

namespace suture::compiler::frontend {

/// Maps every annotated declaration, own and foreign. Each either enters the model or is an error.
/// `semantics` completes instances of templates that are not used yet.
model::Model mapUnit(clang::Sema& semantics, const Includes& includes, HeaderTable& headers,
                     SourceTable& table, AnnotationUses& uses, model::Diagnostics& findings);

}  // namespace suture::compiler::frontend
