#pragma once
// These emit the functions between slots and Cap'n Proto, one set for each declared type.

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// Declares the converters of other headers that this header's generated source calls.
void emitForeignConverters(Code& code, const Context& context);

/// Defines toWire(), fromWire() and isValid() of the header's own types.
void emitConverters(Code& code, const Context& context);

}  // namespace suture::compiler::emit
