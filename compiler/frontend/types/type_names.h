#pragma once
// Finds out which types are named by an alias or by SUTURE_EXTERNAL_TYPE, before any is mapped.

#include <clang/Sema/Sema.h>

#include <optional>
#include <variant>

#include "compiler/frontend/types/data_declaration.h"
#include "compiler/frontend/types/mapping.h"

namespace suture::compiler::frontend {

class TypeNames {
 public:
  TypeNames(Mapping& mapping, clang::Sema& semantics) : mapping_(mapping), semantics_(semantics) {}

  /// The name of a namespace-scope alias for an instance of an annotated template; none otherwise.
  std::optional<DataDeclaration> addAlias(const clang::TypedefNameDecl* alias);

  /// What SUTURE_EXTERNAL_TYPE names; nothing after an error.
  using External = std::variant<std::monostate, DataDeclaration, EnumDeclaration>;
  External addExternal(const clang::CXXMethodDecl* members);

 private:
  /// False after an error: generated code cannot name the type.
  bool checkVisible(const clang::TagDecl* type, const clang::NamedDecl* place);
  /// False after an error: the type has a name already.
  bool add(const clang::TagDecl* type, const NamedTypes::Entry& entry, bool isAlias);

  Mapping& mapping_;
  clang::Sema& semantics_;
};

}  // namespace suture::compiler::frontend
