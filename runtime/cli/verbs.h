#pragma once
// This is what `suture` can do. Each prints to standard output and returns the exit status: 0, or 1
// if the answer is "no"; throws SetupError or UsageError if there is no answer.

#include <suture/loop/event_port.h>
#include "cli/command_line/options.h"

namespace suture::cli {

int ps(loop::EventPort& loop, const Options& options);
int describe(loop::EventPort& loop, const Options& options);
int read(loop::EventPort& loop, const Options& options);
int call(loop::EventPort& loop, const Options& options);
int resume(loop::EventPort& loop, const Options& options);
int watch(loop::EventPort& loop, const Options& options);
int doctor(loop::EventPort& loop, const Options& options);
int why(loop::EventPort& loop, const Options& options);
int makeKeys(loop::EventPort& loop, const Options& options);

}  // namespace suture::cli
