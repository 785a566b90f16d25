#pragma once
// SUTURE_COMPONENT: what a class provides and requires, and what it is made from.

#include "compiler/frontend/mapping.h"

namespace suture::compiler::frontend {

model::Component mapComponentDeclaration(const clang::CXXRecordDecl* declaration, Mapping& mapping);

}  // namespace suture::compiler::frontend
