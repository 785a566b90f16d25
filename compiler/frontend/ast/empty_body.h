#pragma once
// This looks at a constructor's text before clang reads it.

#include <clang/AST/DeclCXX.h>

namespace suture::compiler::frontend {

/// Tells if nothing but initialisers follows the declaration, so that its body is "{}".
bool hasEmptyBody(const clang::CXXConstructorDecl* constructor);

}  // namespace suture::compiler::frontend
