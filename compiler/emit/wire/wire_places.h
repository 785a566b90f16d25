#pragma once
// The places of events and columns in the lock, which name them between two processes.

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

/// Both as tables that the functions below name.
void emitWirePlaces(Code& code, const Context& context, const model::Interface& interface);

/// "toWireNumbers(kArmWireEvents, events)": `set` as the wire has it, or as it is where that is the
/// same.
std::string eventsToWire(const Context& context, const model::Interface& interface,
                         const std::string& set);
std::string eventsFromWire(const Context& context, const model::Interface& interface,
                           const std::string& set);
std::string columnsToWire(const Context& context, const model::Interface& interface,
                          const std::string& set);
std::string columnsFromWire(const Context& context, const model::Interface& interface,
                            const std::string& set);

}  // namespace suture::compiler::emit
