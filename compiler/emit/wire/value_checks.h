#pragma once
// suturec writes these checks for every lane: a handler sees no value that one of them refuses.

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// Emits a function for each message that may hold values which the contract does not admit.
void emitValueChecks(Code& code, const Context& context, const model::Interface& interface);

}  // namespace suture::compiler::emit
