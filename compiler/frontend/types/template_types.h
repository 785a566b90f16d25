#pragma once
// This maps the class templates that have a natural wire form: the standard library's and Eigen's.

#include <clang/AST/DeclTemplate.h>

#include "compiler/frontend/types/type_mapper.h"

namespace suture::compiler::frontend {

MappedType mapTemplate(const clang::ClassTemplateSpecializationDecl* type, const NamedTypes& names);

}  // namespace suture::compiler::frontend
