#pragma once
// This emits how a contract travels as Cap'n Proto, whatever carries its messages.

#include <string>

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// Emits the functions between the slots of a contract and its messages, and the tables that lead
/// to them.
void emitCodec(Code& code, const Context& context, const model::Interface& interface);

/// Names the function that hands them out: "armCodec".
std::string codecFunction(const Context& context, const model::Interface& interface);

}  // namespace suture::compiler::emit
