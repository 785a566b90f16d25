#pragma once
// This shows what a process offers and needs.

#include <suture/names/records.h>
#include <suture/session/clock_offset.h>
#include "cli/peer/peer.h"
#include "cli/values/json.h"

#include <optional>
#include <string>
#include <vector>

namespace suture::cli {

using Connections = std::optional<std::vector<ConnectionRecord>>;

/// Says how each required interface is connected too, where `connections` are known.
Json toJson(const ProcessRecord& process, const Connections& connections);
/// Returns {"same", "offset_ms", "error_ms"}: the process's clock minus ours, and how wrong that
/// may be.
Json toJson(const ClockOffset& clock);
/// Returns a line of it for people; nothing if both have one clock.
std::string clockText(const ClockOffset& clock);
/// Returns a line for each component and each interface, with how a required one is connected where
/// `connections` are known.
std::string componentsText(const std::vector<ComponentRecord>& components,
                           const Connections& connections);

}  // namespace suture::cli
