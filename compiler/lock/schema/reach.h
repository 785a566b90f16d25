#pragma once
// This finds what a node of a lock names, and what that names in turn.

#include <map>
#include <set>
#include <string>

#include "compiler/lock/schema/lock.h"

namespace suture::compiler::lock {

/// Returns "arm/arm.capnp:Pose" of the node and of all that its members lead to, in all locks.
std::set<std::string> reach(const std::map<std::string, Lock>& locks, const std::string& path,
                            const std::string& node);

}  // namespace suture::compiler::lock
