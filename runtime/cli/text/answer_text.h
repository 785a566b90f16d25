#pragma once
// This shows what a command answered, for people and for programs.

#include "cli/peer/provider.h"

#include <string>

namespace suture::cli {

/// Returns the read command of that name. Throws SetupError if there is none, or it is another
/// kind.
const Member& readCommand(const Contract& contract, const std::string& name);

/// Returns text that ends with a line break.
std::string answerText(const Answer& answer);
/// Returns {"command", "kind", "value", "age_ms", "age_error_ms"}: the last three if there are any.
Json answerJson(const Member& command, const Answer& answer);

}  // namespace suture::cli
