#pragma once
// The nodes that a contract has in its lock.

#include <string>

#include "compiler/lock/schema/lock.h"

namespace suture::compiler::lock {

/// The node that says `annotation` of the contract: "cxx" its commands, "eventsOf" its events,
/// "stateOf" its columns. Null if there is none.
const Node* nodeOf(const Lock& lock, const char* annotation, const std::string& contract);

}  // namespace suture::compiler::lock
