#pragma once
// What a process offers and needs.

#include <suture/names/records.h>
#include <suture/session/clock_offset.h>
#include "cli/values/json.h"

#include <string>
#include <vector>

namespace suture::cli {

Json toJson(const ProcessRecord& process);
/// {"same", "offset_ms", "error_ms"}: the process's clock minus ours, and how wrong that may be.
Json toJson(const ClockOffset& clock);
/// A line of it for people; nothing if both have one clock.
std::string clockText(const ClockOffset& clock);
/// A line a component and one an interface.
std::string componentsText(const std::vector<ComponentRecord>& components);

}  // namespace suture::cli
