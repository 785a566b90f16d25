#pragma once
// These emit the C++ files that are generated for a header.

#include <string>

#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// Emits "arm/arm.suture.h": slots, Required and Provided.
std::string headerFile(const Context& context);

/// Emits "arm/arm.suture.cpp": slots, checks, tables, and what calls a component.
std::string sourceFile(const Context& context);

}  // namespace suture::compiler::emit
