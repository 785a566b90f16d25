#pragma once
// A struct on its way into the model.

#include <clang/AST/DeclCXX.h>

#include <optional>
#include <string>

#include "compiler/frontend/ast/annotation.h"
#include "compiler/model/model.h"

namespace suture::compiler::frontend {

/// A struct that enters the model: one that is annotated itself, an instance of a template by its
/// alias, or somebody else's.
struct DataDeclaration {
  const clang::CXXRecordDecl* record;  ///< what it is made of
  const clang::NamedDecl* place;       ///< what gives it its name and home: errors stand there
  std::string name;                    ///< qualified
  std::string wireName;
  /// Of a type that cannot be edited: what SUTURE_EXTERNAL_TYPE says. Absent of any other.
  std::optional<Annotation> external;
  std::optional<std::string> was{};
  model::Lifecycle lifecycle{};
};

/// An enum that enters the model, in the same way.
struct EnumDeclaration {
  const clang::EnumDecl* declaration;
  const clang::NamedDecl* place;
  std::string name;
  std::string wireName;
  std::optional<std::string> was{};
  model::Lifecycle lifecycle{};

  bool isExternal() const { return place != declaration; }
};

}  // namespace suture::compiler::frontend
