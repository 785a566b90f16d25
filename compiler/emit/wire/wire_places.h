#pragma once
// These are the places of events and columns in the lock, which name them between two processes.

#include <string>
#include <vector>

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// Returns for each event, or each read command, of the contract its place in the lock; empty if
/// all have the same place in the contract. They differ where a base got more after the contract
/// was locked: that comes last in the lock, and first in the contract.
std::vector<unsigned> wireEvents(const Context& context, const model::Interface& interface);
std::vector<unsigned> wireColumns(const Context& context, const model::Interface& interface);

/// Returns the number of a command's or an event's method in the lock.
unsigned methodOf(const Context& context, const model::Interface& interface,
                  const model::Command& command);
unsigned methodOf(const Context& context, const model::Interface& interface,
                  const model::Event& event);

/// Emits both as tables.
void emitWirePlaces(Code& code, const Context& context, const model::Interface& interface);

}  // namespace suture::compiler::emit
