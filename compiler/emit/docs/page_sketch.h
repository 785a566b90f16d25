#pragma once
// This writes the example of a reference page that shows a client and a provider of one contract.

#include <string>

#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// Returns the section "Calling and serving Arm". It shows one command, event and read of each way
/// of calling that the contract has.
std::string sketch(const Context& context, const model::Interface& interface);

}  // namespace suture::compiler::emit
