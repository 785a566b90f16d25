#pragma once
// These map Eigen's matrices, quaternions and transforms.

#include <clang/AST/DeclTemplate.h>

#include "compiler/frontend/types/type_mapper.h"

namespace suture::compiler::frontend {

MappedType mapMatrix(const clang::ClassTemplateSpecializationDecl* type, const NamedTypes& names);
MappedType mapQuaternion(const clang::ClassTemplateSpecializationDecl* type,
                         const NamedTypes& names);
MappedType mapTransform(const clang::ClassTemplateSpecializationDecl* type,
                        const NamedTypes& names);

}  // namespace suture::compiler::frontend
