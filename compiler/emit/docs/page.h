#pragma once
// This writes the reference page of a header, for the people who use what it declares.

#include <string>

#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// Emits "arm/arm.suture.md": contracts with their commands, events and errors, components, and
/// every type that these carry, in Markdown.
std::string emitPage(const Context& context);

}  // namespace suture::compiler::emit
