#pragma once
// This says which data members cannot be on the wire, whatever their type.

#include "compiler/frontend/data/candidate.h"

namespace suture::compiler::frontend {

/// Tells if the field may lie where its type is not aligned, so that no reference binds to it.
bool isPacked(const clang::FieldDecl* field);

/// Reports why a field cannot be on the wire, whatever its type. Returns true if it reported an
/// error.
bool rejectField(const Candidate& candidate, Mapping& mapping);

}  // namespace suture::compiler::frontend
