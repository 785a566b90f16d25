#pragma once
// These are arguments of a command as they are typed.

#include "cli/command_line/options.h"
#include "cli/values/json.h"

#include <functional>
#include <string>

namespace suture::cli {

/// Returns what --args has, and then each "goal.pose.x=0.1". A value that is JSON stays JSON;
/// anything else is a text. Throws UsageError, also for what is given twice; a setting may replace
/// what --args has.
Json argumentsOf(const Options& options);

/// Tells if a setting, which has `value` as JSON, stands for a text.
using IsText = std::function<bool(const std::string& name, const Json& value)>;

/// Makes texts of the settings among `arguments` that stand for one: "name=123" gives the
/// characters, because the shell takes the quotes that a text has in JSON.
void takeTexts(Json& arguments, const Options& options, const IsText& isText);

}  // namespace suture::cli
