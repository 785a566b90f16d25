#pragma once
// This shows a contract as a page for people.

#include "cli/contract/contract.h"

#include <string>

namespace suture::cli {

/// Returns commands, events and types with kinds, units and documentation, from the
/// self-description.
std::string contractText(const Contract& contract);

}  // namespace suture::cli
