#pragma once
// The expression that gives a member its value in the default constructor of its class.

#include <clang/AST/Decl.h>
#include <clang/AST/DeclCXX.h>
#include <clang/AST/Expr.h>

namespace suture::compiler::frontend {

/// Null: there is none that can be seen. The constructor's own comes before that of the
/// declaration, as in C++.
const clang::Expr* initialiserOf(const clang::FieldDecl* field);

/// "{}", or a constructor without arguments.
bool saysNothing(const clang::Expr* initialiser);

/// The default constructor that somebody wrote; null if there is none.
const clang::CXXConstructorDecl* writtenConstructor(const clang::FieldDecl* field);

/// Whether statements that suturec does not follow may set members: it has a body, hands over to
/// another, or is defined elsewhere.
bool mayAssign(const clang::CXXConstructorDecl* constructor);

}  // namespace suture::compiler::frontend
