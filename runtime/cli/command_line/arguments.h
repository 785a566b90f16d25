#pragma once
// Arguments of a command as they are typed.

#include "cli/command_line/options.h"
#include "cli/values/json.h"

namespace suture::cli {

/// What --args has, and then each "goal.pose.x=0.1". A value that is JSON is that, anything else a
/// text. Throws UsageError.
Json argumentsOf(const Options& options);

}  // namespace suture::cli
