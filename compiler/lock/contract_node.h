#pragma once
// This finds the nodes that a contract has in its lock.

#include <string>

#include "compiler/lock/schema/lock.h"

namespace suture::compiler::lock {

/// Returns the node whose `annotation` names the contract: the node of "cxx" has its commands, that
/// of "eventsOf" its events, that of "stateOf" its columns. Returns null if there is none.
const Node* nodeOf(const Lock& lock, const char* annotation, const std::string& contract);

}  // namespace suture::compiler::lock
