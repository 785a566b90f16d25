#pragma once
// These are the two sides of a trial in real time, each in a process of its own.

#include <cstdio>

#include "experiment/link/link_end.h"
#include "experiment/trial.h"

namespace experiment {

/// These are the addresses of the sides on their link.
constexpr const char* kConsoleAddress = "10.213.8.1";
constexpr const char* kTableAddress = "10.213.8.2";

/// Call them in a process that has no thread yet. Each enters `end`, plays its side over Suture's
/// lanes, and writes what is true there to `record`. The console plays until Forked::end(), the
/// table until the guide has guided for kLength, or has not begun within half a minute. Both throw
/// suture::SetupError.
void playConsole(const Trial& trial, const LinkEnd& end, std::FILE* record);
void playTable(const Trial& trial, const LinkEnd& end, std::FILE* record);

}  // namespace experiment
