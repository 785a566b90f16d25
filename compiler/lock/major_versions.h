#pragma once
// The major of a contract: how often it was broken on purpose, plus one.

#include <set>
#include <string>

#include "compiler/lock/schema/lock.h"

namespace suture::compiler::lock {

/// 1 where the lock says nothing.
unsigned majorOf(const Node& node);

/// The major of the contract with that qualified C++ name.
unsigned majorOf(const Locks& locks, const std::string& contract);

/// Raises the major of each contract in the locks of `own` that reaches one of `broken`
/// ("arm/arm.capnp:Pose").
void raiseMajors(std::map<std::string, Lock>& locks, const std::set<std::string>& own,
                 const std::set<std::string>& broken);

}  // namespace suture::compiler::lock
