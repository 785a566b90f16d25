#pragma once
// This shows what a command answered, for people and for programs.

#include "cli/peer/provider.h"

#include <string>

namespace suture::cli {

/// Returns the read command of that name. Throws SetupError if there is none, or it is another
/// kind.
const Member& readCommand(const Contract& contract, const std::string& name);

/// Returns " m" if that is the unit of a command's result or an event's payload; else "". Members
/// of a struct have theirs in their labels.
std::string unitOf(const Member& member, const Json& value);
/// Returns text that ends with a line break.
std::string answerText(const Member& command, const Answer& answer);
/// Returns {"command", "kind", "value", "age_ms", "age_error_ms"}: the last three if there are any.
Json answerJson(const Member& command, const Answer& answer);

}  // namespace suture::cli
