#pragma once
// This writes the part of a reference page that tells of one contract: commands, events, errors.

#include <string>

#include "compiler/emit/docs/page_types.h"

namespace suture::compiler::emit {

std::string commandSections(const Context& context, const PageTypes& types,
                            const model::Interface& interface);

}  // namespace suture::compiler::emit
