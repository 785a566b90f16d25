#pragma once
// What a process offers and needs, for the global manager and for tools.

#include <suture/manager/records.h>
#include <suture/wiring/directory.h>

namespace suture {

/// Of all components added so far. The thread that adds them, or any after that.
std::vector<ComponentRecord> describeComponents(const Directory& directory);

}  // namespace suture
