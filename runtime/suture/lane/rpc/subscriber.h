#pragma once
// This is the far end of a subscription, as the provider's process sees it.

#include <suture/loop/kj_comparisons.h>  // first

#include <capnp/capability.h>
#include <suture/component/contract/interface_info.h>
#include <suture/rt/queue/event_queue.h>
#include <suture/rt/state/state_table.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace suture::rpc {

/// Belongs to the control thread. Sends events and rows as calls.
class Subscriber {
 public:
  /// `client` receives events of `contract`, which the provider's may derive from.
  Subscriber(capnp::Capability::Client client, const InterfaceInfo& contract)
      : client_(kj::mv(client)), contract_(contract) {}

  /// Sends an event, if its contract has it; the promise resolves when the subscriber has taken it.
  kj::Promise<void> event(const rt::EventRecord& record);
  /// Sends the columns that have a value; `slots[i]` is the slot of column i.
  kj::Promise<void> row(const rt::StateTable::Row& row, std::span<const std::byte* const> slots);

 private:
  capnp::Capability::Client client_;
  const InterfaceInfo& contract_;
};

}  // namespace suture::rpc
