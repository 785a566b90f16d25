#pragma once
// These map durations and stamps.

#include <clang/AST/DeclTemplate.h>

#include "compiler/frontend/types/type_mapper.h"

namespace suture::compiler::frontend {

MappedType mapDuration(const clang::ClassTemplateSpecializationDecl* type, const NamedTypes& names);
MappedType mapTimePoint(const clang::ClassTemplateSpecializationDecl* type,
                        const NamedTypes& names);

}  // namespace suture::compiler::frontend
