#pragma once
// This says if two processes mean the same by the bytes of a contract's slots, and may exchange
// them as they are.

#include <suture/component/contract/interface_info.h>

#include <string>

namespace suture {

/// Returns a digest of the types in their order, of the tables and of this release's own form. It
/// is equal for two builds of a contract whose records, columns and queues lie in memory alike.
std::string memoryLayout(const InterfaceInfo& info);

/// Returns true if values of this contract contain, or may contain, points in time of a steady
/// clock, which mean something else on another machine, and its tables do not say where.
bool hidesStamps(const InterfaceInfo& info);

/// Returns why the slots of a client cannot be exchanged with its provider as they are; "" if they
/// can. `contract` is the provider's, `layout` the client's.
std::string whyOtherSlots(const InterfaceInfo& contract, const std::string& layout);

}  // namespace suture
