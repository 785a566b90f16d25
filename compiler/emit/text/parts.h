#pragma once
// These emit the parts of the generated files, one emitter a file of this folder.

#include <string>

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// Emits suture::Members of the header's types with members that are not public.
void emitMembers(Code& code, const Context& context);

/// Emits slot structs of the header's types, their store() and load() declared.
void emitSlots(Code& code, const Context& context);
/// Defines those store() and load().
void emitSlotConversions(Code& code, const Context& context);

/// Emits the slots of a contract's command arguments and of events with several values, their
/// store() and load() declared; the numbers of its commands and events.
void emitArguments(Code& code, const Context& context, const model::Interface& interface);
/// Defines those store() and load().
void emitArgumentConversions(Code& code, const Context& context, const model::Interface& interface);

/// Emits Required<Contract>: what a client calls and subscribes to.
void emitRequired(Code& code, const Context& context, const model::Interface& interface);

/// Emits Provided<Contract>: what serves the contract from a component.
void emitProvided(Code& code, const Context& context, const model::Interface& interface);

/// Emits static_asserts that the compiler of the component sees what suturec saw.
void emitChecks(Code& code, const Context& context);

/// Emits the constant tables of a contract: commands, events, self-description.
void emitTables(Code& code, const Context& context, const model::Interface& interface);

/// Emits interfaceInfo<Contract>(), which hands out the tables.
void emitInfo(Code& code, const Context& context, const model::Interface& interface);

/// Emits Provided<Contract>::Scratch::reserved(), where a command has an argument that owns memory.
void emitReserved(Code& code, const Context& context, const model::Interface& interface);

/// Emits Provided<Contract>::execute(): the switch that calls the component.
void emitExecute(Code& code, const Context& context, const model::Interface& interface);

/// Returns "arm/arm.suture.json": all that the header declares.
std::string emitJson(const Context& context);

/// Returns the self-description of one contract and the types it reaches, as it travels with a
/// connection.
std::string describe(const Context& context, const model::Interface& interface);

}  // namespace suture::compiler::emit
