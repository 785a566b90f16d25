#pragma once
// The major of a contract counts how often it was broken on purpose, plus one.

#include <set>
#include <string>

#include "compiler/lock/schema/lock.h"
#include "compiler/lock/schema/node_index.h"

namespace suture::compiler::lock {

/// Returns the node's major, which is 1 if the lock says nothing.
unsigned majorOf(const Node& node);

/// Returns the major of the contract with that qualified C++ name, which is 1 if no lock has it.
unsigned majorOf(const NodeIndexes& locks, const std::string& contract);

/// Raises the major of each contract in the locks of `own` that reaches one of `broken`
/// ("arm/arm.capnp:Pose").
void raiseMajors(std::map<std::string, Lock>& locks, const std::set<std::string>& own,
                 const std::set<std::string>& broken);

}  // namespace suture::compiler::lock
