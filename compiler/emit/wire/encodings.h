#pragma once
// suture::encode() and decode() of the header's types, for files and messages of a user's own.

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// Declares them in namespace suture, for the generated header.
void declareEncodings(Code& code, const Context& context);
/// Defines them in namespace suture, for the generated source.
void emitEncodings(Code& code, const Context& context);

}  // namespace suture::compiler::emit
