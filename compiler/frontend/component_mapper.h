#pragma once
// This maps SUTURE_COMPONENT: what a class provides and requires, and what it is made from.

#include "compiler/frontend/types/mapping.h"

namespace suture::compiler::frontend {

model::Component mapComponentDeclaration(const clang::CXXRecordDecl* declaration, Mapping& mapping);

/// Tells if the declaration is a suture::Required member.
bool isRequiredInterface(const clang::Decl* declaration);

}  // namespace suture::compiler::frontend
