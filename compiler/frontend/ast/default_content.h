#pragma once
// These look at an initialiser of a member that is no single number: text, a list, a matrix, a
// struct.

#include <clang/AST/ASTContext.h>
#include <clang/AST/Expr.h>

#include <cstddef>
#include <optional>

namespace suture::compiler::frontend {

/// Returns the string literal below the conversions and constructions around it; null if there is
/// none, or more than one.
const clang::StringLiteral* literalIn(const clang::Expr* initialiser);

/// Returns how many elements or bytes the initialiser spells out; none if that cannot be seen.
std::optional<std::size_t> lengthOf(const clang::Expr* initialiser);

/// Tells if a part of the initialiser is NaN, as far as the parts are constants.
bool holdsNan(const clang::Expr* initialiser, const clang::ASTContext& context);

}  // namespace suture::compiler::frontend
