#pragma once
// What a command answered, for people and for programs.

#include "cli/peer/provider.h"

#include <string>

namespace suture::cli {

/// The read command of that name. Throws SetupError: there is none, or it is another kind.
const Member& readCommand(const Contract& contract, const std::string& name);

/// Ends with a line break.
std::string answerText(const Answer& answer);
/// {"command", "kind", "value", "age_ms", "age_error_ms"}: the last three if there are any.
Json answerJson(const Member& command, const Answer& answer);

}  // namespace suture::cli
