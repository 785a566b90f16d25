#pragma once
// This is what `suture` can do. Each prints to standard output and returns the exit status: 0, or 1
// if the answer is "no"; throws SetupError or UsageError if there is no answer.

#include <suture/loop/event_port.h>
#include "cli/command_line/options.h"

namespace suture::cli {

int ps(rpc::EventPort& loop, const Options& options);
int describe(rpc::EventPort& loop, const Options& options);
int read(rpc::EventPort& loop, const Options& options);
int call(rpc::EventPort& loop, const Options& options);
int resume(rpc::EventPort& loop, const Options& options);
int watch(rpc::EventPort& loop, const Options& options);
int doctor(rpc::EventPort& loop, const Options& options);
int why(rpc::EventPort& loop, const Options& options);
int makeKeys(rpc::EventPort& loop, const Options& options);

}  // namespace suture::cli
