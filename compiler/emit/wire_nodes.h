#pragma once
// What of a contract a peer of another build compares with its own: see wiring/compatibility.h.

#include <nlohmann/json_fwd.hpp>

#include "compiler/emit/context.h"

namespace suture::compiler::emit {

/// Of the contract and each type that it leads to: id, kind and members; of each member its place,
/// its type (a declared one by its id, which outlives renames) and what bytes of it mean.
nlohmann::ordered_json wireNodes(const Context& context, const model::Interface& interface);

}  // namespace suture::compiler::emit
