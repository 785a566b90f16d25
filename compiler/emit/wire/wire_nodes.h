#pragma once
// Writes what a peer of another build compares of a contract: see wiring/compatibility.h.

#include <nlohmann/json_fwd.hpp>

#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// Describes the contract and each type that it leads to: id, kind and members; for each member its
/// place, its type (a declared one by its id, which outlives renames) and what its bytes mean.
nlohmann::ordered_json wireNodes(const Context& context, const model::Interface& interface);

}  // namespace suture::compiler::emit
