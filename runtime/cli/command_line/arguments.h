#pragma once
// These are arguments of a command as they are typed.

#include "cli/command_line/options.h"
#include "cli/values/json.h"

namespace suture::cli {

/// Returns what --args has, and then each "goal.pose.x=0.1". A value that is JSON stays JSON;
/// anything else is a text. Throws UsageError, also for what is given twice; a setting may replace
/// what --args has.
Json argumentsOf(const Options& options);

}  // namespace suture::cli
