#pragma once
// This says if a contract has values without a bound, which have no slot of a fixed size.

#include <suture/component/contract/interface_info.h>

#include <string>

namespace suture {

/// Returns which values of this contract have no bound; "" if all have one.
std::string whyUnbounded(const InterfaceInfo& info);

/// Throws SetupError if a task would provide or require a contract with unbounded values, because a
/// task's thread never allocates.
void refuseUnbounded(const InterfaceInfo& info, bool isTask);

}  // namespace suture
