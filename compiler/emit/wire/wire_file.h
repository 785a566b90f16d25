#pragma once
// This emits the C++ file that is generated for a header's way to Cap'n Proto.

#include <string>

#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// Emits "arm/arm.wire.cpp": converters of types, codecs of contracts.
std::string wireFile(const Context& context);

}  // namespace suture::compiler::emit
