#pragma once
// This finds out which types are named by an alias or by SUTURE_EXTERNAL_TYPE, before any is
// mapped.

#include <clang/Sema/Sema.h>

#include <optional>
#include <variant>

#include "compiler/frontend/types/data_declaration.h"
#include "compiler/frontend/types/mapping.h"

namespace suture::compiler::frontend {

class TypeNames {
 public:
  TypeNames(Mapping& mapping, clang::Sema& semantics) : mapping_(mapping), semantics_(semantics) {}

  /// Notes the name that a namespace-scope alias gives an instance of an annotated template.
  /// Returns none if the alias is no such, or after an error.
  std::optional<DataDeclaration> addAlias(const clang::TypedefNameDecl* alias);

  /// An External is what SUTURE_EXTERNAL_TYPE names, or nothing after an error.
  using External = std::variant<std::monostate, DataDeclaration, EnumDeclaration>;
  External addExternal(const clang::CXXMethodDecl* members);

 private:
  /// Reports a type that generated code cannot name, and then returns false.
  bool checkVisible(const clang::TagDecl* type, const clang::NamedDecl* place);
  /// Notes the name of a type. Returns false if the type has one already, and reports another one.
  bool add(const clang::TagDecl* type, const NamedTypes::Entry& entry, bool isAlias);

  Mapping& mapping_;
  clang::Sema& semantics_;
};

}  // namespace suture::compiler::frontend
