#pragma once
// What a process offers and needs.

#include <suture/cli/json.h>
#include <suture/manager/records.h>

#include <string>
#include <vector>

namespace suture::cli {

Json toJson(const ProcessRecord& process);
/// A line a component and one an interface.
std::string componentsText(const std::vector<ComponentRecord>& components);

}  // namespace suture::cli
