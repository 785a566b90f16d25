#pragma once
// Finds out which types are named by an alias or by SUTURE_EXTERNAL_TYPE, before any is mapped.

#include <clang/Sema/Sema.h>

#include <optional>

#include "compiler/frontend/types/data_declaration.h"
#include "compiler/frontend/types/mapping.h"

namespace suture::compiler::frontend {

class TypeNames {
 public:
  TypeNames(Mapping& mapping, clang::Sema& semantics) : mapping_(mapping), semantics_(semantics) {}

  /// The name of a namespace-scope alias for an instance of an annotated template; none otherwise.
  std::optional<DataDeclaration> addAlias(const clang::TypedefNameDecl* alias);

  /// The name of what SUTURE_EXTERNAL_TYPE declares; none after an error.
  std::optional<DataDeclaration> addExternal(const clang::CXXMethodDecl* members);

 private:
  /// False after an error: the type has a name already.
  bool add(const DataDeclaration& declared);

  Mapping& mapping_;
  clang::Sema& semantics_;
};

}  // namespace suture::compiler::frontend
