#pragma once
// Default member initialisers that are constants.

#include <clang/AST/Decl.h>

#include <string>

namespace suture::compiler::frontend {

/// The initialiser as JSON where it is a constant of a scalar, enum (its enumerator's name) or
/// string. Empty: there is none, or it is no such constant.
std::string defaultJsonOf(const clang::FieldDecl* field);

/// Whether the compiler knows the value.
bool isConstant(const clang::Expr* initialiser, const clang::ASTContext& context);

}  // namespace suture::compiler::frontend
