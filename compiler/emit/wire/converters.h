#pragma once
// These emit the functions between slots and Cap'n Proto, one set for each declared type.

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// Declares the converters of other headers that this header's converters call.
void emitForeignConverters(Code& code, const Context& context);

/// Defines toWire() and fromWire() of the header's own types.
void emitConverters(Code& code, const Context& context);

}  // namespace suture::compiler::emit
