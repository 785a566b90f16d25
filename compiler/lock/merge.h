#pragma once
// This brings header and lock together into the lock as it should become. It judges nothing, since
// differences.h compares the earlier lock with this one.

#include <string>
#include <vector>

#include "compiler/lock/schema/lock.h"
#include "compiler/lock/schema/wanted.h"

namespace suture::compiler::lock {

/// Returns the lock as it should be. `old` is the committed one, or one without nodes if there is
/// none; `project` goes into the ids of what is new.
Lock merge(const std::vector<WantedNode>& wanted, const model::Header& header, const Lock& old,
           const std::string& project);

}  // namespace suture::compiler::lock
