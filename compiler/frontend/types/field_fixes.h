#pragma once
// This says what `suturec --fix` may do about a member whose type cannot go over a wire.

#include <vector>

#include "compiler/frontend/types/mapping.h"
#include "compiler/frontend/types/type_mapper.h"

namespace suture::compiler::frontend {

/// Returns the changes, or none if a person has to decide.
std::vector<model::Fix> fixesFor(const clang::NamedDecl* declaration, const TypeProblem& problem,
                                 Mapping& mapping);

}  // namespace suture::compiler::frontend
