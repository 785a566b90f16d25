#pragma once
// This shows what a process offers and needs.

#include <suture/names/records.h>
#include <suture/session/clock_offset.h>
#include "cli/values/json.h"

#include <string>
#include <vector>

namespace suture::cli {

Json toJson(const ProcessRecord& process);
/// Returns {"same", "offset_ms", "error_ms"}: the process's clock minus ours, and how wrong that
/// may be.
Json toJson(const ClockOffset& clock);
/// Returns a line of it for people; nothing if both have one clock.
std::string clockText(const ClockOffset& clock);
/// Returns a line for each component and each interface.
std::string componentsText(const std::vector<ComponentRecord>& components);

}  // namespace suture::cli
