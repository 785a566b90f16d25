#pragma once
// suturec writes these checks for every lane: a handler sees no value that one of them refuses.

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// Declares a check for each enum and each struct of the header, for the generated header.
void declareTypeChecks(Code& code, const Context& context);
/// Defines these checks: isKnownMode() and isValid().
void emitTypeChecks(Code& code, const Context& context);

/// Emits a function for each message that may hold values which the contract does not admit.
void emitValueChecks(Code& code, const Context& context, const model::Interface& interface);

}  // namespace suture::compiler::emit
