#pragma once
// Without was() a rename looks like something removed and something new of one form. This finds
// such pairs, so that a person can be asked.

#include <string>

#include "compiler/lock/moves/same_nodes.h"
#include "compiler/lock/schema/lock.h"
#include "compiler/lock/schema/renames.h"

namespace suture::compiler::lock {

/// Returns the name of a member of `old` that is gone from `now`, and that `added`, a new member of
/// `now`, can be under another name; "" if there is none.
std::string earlierNameOf(const Node& old, const Node& now, const Member& added,
                          const Renames& renames);

/// Does the same for a type or contract that is new: `nodes` are those of the new version.
std::string earlierNameOf(const Lock& old, const SameNodes& nodes, const Node& added,
                          const Renames& renames);

/// Says what to do if it was that; returns "" for an empty name.
std::string hintOfRename(const std::string& earlierName);

}  // namespace suture::compiler::lock
