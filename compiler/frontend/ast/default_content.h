#pragma once
// These look at an initialiser of a member that is no single number: text, a list, a matrix, a
// struct.

#include <clang/AST/ASTContext.h>
#include <clang/AST/Expr.h>

#include <vector>

#include "compiler/model/type.h"

namespace suture::compiler::frontend {

/// Returns the string literal below the conversions and constructions around it; null if there is
/// none, or more than one.
const clang::StringLiteral* literalIn(const clang::Expr* initialiser);

/// This is what can be seen of an initialiser, at any depth of its type.
struct DefaultContent {
  std::vector<double> numbers;  ///< those to which a range() of the member applies
  bool isTooLong = false;       ///< something has more elements or bytes than its capacity
};

DefaultContent contentOf(const clang::Expr* initialiser, const model::Type& type,
                         const clang::ASTContext& context);

/// Tells if a part of the initialiser is NaN, as far as the parts are constants.
bool holdsNan(const clang::Expr* initialiser, const clang::ASTContext& context);

}  // namespace suture::compiler::frontend
