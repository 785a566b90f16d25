#pragma once
// These find the expression that gives a member its value in the default constructor of its class.

#include <clang/AST/Decl.h>
#include <clang/AST/DeclCXX.h>
#include <clang/AST/Expr.h>

namespace suture::compiler::frontend {

/// Returns the initialiser, or null if none can be seen. The constructor's own comes before that of
/// the declaration, as in C++.
const clang::Expr* initialiserOf(const clang::FieldDecl* field);

/// Returns the member of the template that the field is an instance of, else the field itself.
const clang::FieldDecl* patternOf(const clang::FieldDecl* field);

/// Returns true for "{}", and for a constructor without arguments.
bool saysNothing(const clang::Expr* initialiser);

/// Tells if a constructor that a user wrote may set the member where suturec does not follow: in
/// its body, in another constructor, in another file. What its list says is seen.
bool mayBeAssigned(const clang::FieldDecl* field);

/// Tells if a constructor that a user wrote says what the base is, or may do so.
bool mayBeInitialised(const clang::CXXRecordDecl* record, const clang::CXXBaseSpecifier& base);

}  // namespace suture::compiler::frontend
