#pragma once
// This maps a data member of a struct.

#include <optional>

#include "compiler/frontend/data/candidate.h"

namespace suture::compiler::frontend {

/// Returns nothing for a member that is skipped, or that is an error.
std::optional<model::Field> mapField(const Candidate& candidate, Mapping& mapping);

}  // namespace suture::compiler::frontend
