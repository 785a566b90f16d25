#pragma once
// These say how values of a class get from one place to another.

#include <clang/AST/Type.h>
#include <clang/Sema/Sema.h>

namespace suture::compiler::frontend {

/// Tells if a value can be copied.
bool canBeCopied(clang::QualType type, clang::Sema& semantics);

/// Tells if a value can be moved, and so can the elements of a std::vector.
bool canBeMoved(clang::QualType type, clang::Sema& semantics);

/// Tells if a value can be moved, and if its class has code for that.
bool movesByCode(clang::QualType type, clang::Sema& semantics);

}  // namespace suture::compiler::frontend
