#pragma once
// This describes what a process offers and needs, for the global manager and for tools.

#include <suture/names/records.h>
#include <suture/wiring/directory.h>

namespace suture {

/// The thread that adds components calls this, or any thread once all have been added. Describes
/// the components that have been added so far.
std::vector<ComponentRecord> describeComponents(const Directory& directory);

}  // namespace suture
