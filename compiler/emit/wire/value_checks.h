#pragma once
// suturec writes these checks for every lane: a handler sees no value that one of them refuses.

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// A function for each message whose values may be such that the contract does not admit them.
void emitValueChecks(Code& code, const Context& context, const model::Interface& interface);

}  // namespace suture::compiler::emit
