#pragma once
// This is the C++ of what a handler may act on: no NaN, nothing outside a range(), no enumerator
// that the header lacks.

#include <string>
#include <vector>

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"
#include "compiler/emit/wire/wire_form.h"

namespace suture::compiler::emit {

/// Names the function that tells if an enum's slot holds one of its values: "isKnownMode",
/// qualified where it is another namespace's than the header's.
std::string enumCheck(const std::string& enumName, const Context& context);

/// Names the check of a command's arguments: "acceptsArmMove"; empty if any will do.
std::string argumentsCheck(const model::Interface& interface, const model::Command& command,
                           const Context& context);

/// Returns true for the check of a struct, which is there for whatever has one in it.
bool isStructCheck(const std::string& check);

/// Names the check of a command's result: "acceptsArmDistanceResult", for a struct "isValid"; empty
/// if any will do.
std::string resultCheck(const model::Interface& interface, const model::Command& command,
                        const Context& context);

/// Names the check of an event's payload: "acceptsArmMovedEvent", for one struct "isValid"; empty
/// if any will do.
std::string payloadCheck(const model::Interface& interface, const model::Event& event,
                         const Context& context);

/// Tells if there is anything that emitValidity() would check.
bool hasConditions(const std::vector<WireValue>& values, const Context& context);

/// Returns the parameters of such a function for `slot`, a type; they are named as far as it uses
/// them.
std::string validityParameters(const std::string& slot, const std::vector<WireValue>& values,
                               const Context& context);

/// Emits the return of a check: true if every number is finite and within its range, and every enum
/// known; `path` is told which is the first that is not.
void emitValidity(Code& code, const std::vector<WireValue>& values, const Context& context);

}  // namespace suture::compiler::emit
