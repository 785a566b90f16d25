#pragma once
// A big header gives several source files of each kind, so that a build compiles them beside each
// other and no compiler needs gigabytes. Each has a share of the header's types and contracts.

#include <string>
#include <vector>

#include "compiler/model/model.h"

namespace suture::compiler::emit {

/// Returns the header with share `index` of `count` of what it declares: about as much as any other
/// share has, in the header's order. Components belong to the first.
model::Header shareOf(const model::Header& header, unsigned index, unsigned count);

/// Returns the identities of the nodes that a lock has for what the header, or the share of one,
/// declares: see lock::identity().
std::vector<std::string> nodesOf(const model::Header& header);

/// Tells if the header, or the share of one, declares the type.
bool declares(const model::Header& header, const std::string& type);

}  // namespace suture::compiler::emit
