#pragma once
// Whether two processes mean the same by the bytes of a contract's slots.

#include <suture/component/interface_info.h>

#include <string>

namespace suture::shm {

/// Equal for two builds of a contract whose records, columns and queues lie in memory alike: a
/// digest of the types in their order, of the tables and of this release's own form.
std::string memoryLayout(const InterfaceInfo& info);

/// Why values of this contract cannot lie in shared memory; "" if they can: every one has a bound.
std::string whyNotShared(const InterfaceInfo& info);

/// True if values of this contract have points in time of a steady clock in them, which mean
/// another thing on another machine.
bool carriesStamps(const InterfaceInfo& info);

}  // namespace suture::shm
