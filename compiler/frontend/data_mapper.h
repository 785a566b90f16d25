#pragma once
// SUTURE_TYPE: structs and enums.

#include "compiler/frontend/mapping.h"

namespace suture::compiler::frontend {

model::Enum mapEnumDeclaration(const clang::EnumDecl* declaration, Mapping& mapping);
model::Struct mapStructDeclaration(const clang::CXXRecordDecl* declaration, Mapping& mapping);

}  // namespace suture::compiler::frontend
