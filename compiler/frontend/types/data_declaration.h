#pragma once
// These are a struct and an enum on their way into the model.

#include <clang/AST/DeclCXX.h>

#include <optional>
#include <string>

#include "compiler/frontend/ast/annotation.h"
#include "compiler/model/model.h"

namespace suture::compiler::frontend {

/// A DataDeclaration is a struct that enters the model: one that is annotated itself, an instance
/// of a template by its alias, or a foreign one that SUTURE_EXTERNAL_TYPE names.
struct DataDeclaration {
  const clang::CXXRecordDecl* record;  ///< the struct whose members it has
  const clang::NamedDecl* place;       ///< it gives the name and the home, so errors stand there
  std::string name;                    ///< qualified
  std::string wireName;
  /// SUTURE_EXTERNAL_TYPE says this of a type that cannot be edited; it is absent if the type can
  /// be.
  std::optional<Annotation> external;
  std::optional<std::string> was{};
  model::Lifecycle lifecycle{};
};

/// An EnumDeclaration is an enum that enters the model in the same way.
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
