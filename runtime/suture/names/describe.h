#pragma once
// This describes what a process offers and needs, for the global manager and for tools.

#include <suture/names/records.h>
#include <suture/wiring/directory.h>

namespace suture {

/// The thread that adds components, or any after that. Describes all components that were added so
/// far.
std::vector<ComponentRecord> describeComponents(const Directory& directory);

}  // namespace suture
