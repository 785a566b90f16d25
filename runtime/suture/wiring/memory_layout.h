#pragma once
// Whether two processes mean the same by the bytes of a contract's slots, and may exchange them as
// they are.

#include <suture/component/contract/interface_info.h>

#include <string>

namespace suture {

/// Equal for two builds of a contract whose records, columns and queues lie in memory alike: a
/// digest of the types in their order, of the tables and of this release's own form.
std::string memoryLayout(const InterfaceInfo& info);

/// Which values of this contract have no bound, and so no slot of a fixed size; "" if all have one.
std::string whyUnbounded(const InterfaceInfo& info);

/// True if values of this contract have, or may have, points in time of a steady clock in them,
/// which mean another thing on another machine, and its tables do not say where.
bool hidesStamps(const InterfaceInfo& info);

/// Why the slots of a client cannot be exchanged with its provider as they are; "" if they can.
/// `contract`: the provider's; `layout`: the client's.
std::string whyOtherSlots(const InterfaceInfo& contract, const std::string& layout);

}  // namespace suture
