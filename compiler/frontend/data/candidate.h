#pragma once
// This says which data members of a struct are to be on the wire.

#include <clang/AST/DeclCXX.h>

#include <string>
#include <vector>

#include "compiler/frontend/types/data_declaration.h"
#include "compiler/frontend/types/mapping.h"

namespace suture::compiler::frontend {

/// A Candidate is a data member on its way into the model.
struct Candidate {
  const clang::FieldDecl* field;
  Annotation annotation;
  bool isExternal;  ///< true if its class cannot be edited
  bool reachable;   ///< true if suture::Members reaches it even if it is not public

  /// Returns what errors call it.
  std::string subject() const { return "field '" + field->getNameAsString() + "'"; }
};

/// Tells if SUTURE_EXTERNAL_TYPE means each public member.
bool meansAll(const Annotation& external);

/// Returns all that its author means, also those that say skip().
std::vector<Candidate> candidatesOf(const DataDeclaration& declared, Mapping& mapping);

}  // namespace suture::compiler::frontend
