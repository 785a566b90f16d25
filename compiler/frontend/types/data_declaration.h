#pragma once
// A struct on its way into the model.

#include <clang/AST/DeclCXX.h>

#include <optional>
#include <string>
#include <vector>

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
  /// The members that count, of somebody else's; absent: all of them.
  std::optional<std::vector<ExternalMember>> listed;
  std::optional<std::string> was{};
  model::Lifecycle lifecycle{};
};

}  // namespace suture::compiler::frontend
