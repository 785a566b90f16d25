#pragma once
// What the initialiser of a member holds that is no single number: text, a list, a matrix, a
// struct.

#include <clang/AST/ASTContext.h>
#include <clang/AST/Expr.h>

#include <cstddef>
#include <optional>

namespace suture::compiler::frontend {

/// The string literal below the conversions and constructions around it; null if there is none, or
/// more than one.
const clang::StringLiteral* literalIn(const clang::Expr* initialiser);

/// How many elements or bytes it spells out; none if that cannot be seen.
std::optional<std::size_t> lengthOf(const clang::Expr* initialiser);

/// Whether a part of it is NaN, as far as the parts are constants.
bool holdsNan(const clang::Expr* initialiser, const clang::ASTContext& context);

}  // namespace suture::compiler::frontend
