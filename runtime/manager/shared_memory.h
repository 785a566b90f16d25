#pragma once
// Memory blocks as capabilities: what the shm lane needs of the control connection.

#include <suture/transport/rpc/kj_comparisons.h>  // first

#include <suture/base/memory_block.h>
#include <suture/peer.capnp.h>
#include <suture/transport/rpc/control_thread.h>
#include <suture/transport/rpc/provider_end.h>
#include <suture/transport/shm/shared_channel.h>

#include <memory>
#include <string>

namespace suture {

/// The provider's contract or the one of its bases that is the client's, whose hash is `hash`; null
/// if they are not from one build.
const InterfaceInfo* sameContract(const InterfaceInfo& provided, const std::string& hash);

/// Why the slots of a client cannot be exchanged with its provider as they are; "" if they can.
/// `contract`: sameContract(); `layout`: the client's.
std::string whyOtherSlots(const InterfaceInfo* contract, capnp::Text::Reader layout);

/// Hands out the descriptor of `block`, and keeps it for as long as anybody has the capability.
wire::SharedMemory::Client handOut(std::shared_ptr<MemoryBlock> block);

/// The block behind a capability. Rejects: it has none, as over TCP, or is not as MemoryBlock
/// demands.
kj::Promise<std::shared_ptr<MemoryBlock>> receive(wire::SharedMemory::Client memory,
                                                  std::size_t size, MemoryBlock::Others others);

void toWire(const shm::SharedParts& parts, wire::SharedChannel::Builder out);
/// Rejects as receive() does, or if it would take too much memory.
kj::Promise<shm::SharedParts> receive(wire::SharedChannel::Reader in,
                                      const InterfaceInfo& contract);

/// The provider's end of a connection whose data go another way, through shared memory or frames:
/// passes the status on.
class StatusPort final : public rpc::ProviderEnd, private rpc::Pump {
 public:
  /// `channel` is about to be attached to the provider; its watcher is the control thread.
  StatusPort(rpc::ControlThread& control, std::shared_ptr<Channel> channel);
  ~StatusPort() noexcept(false) { close(); }

 private:
  void ending() override { control_.remove(*this); }
  void pump() override { pumpStatus(); }

  rpc::ControlThread& control_;
};

}  // namespace suture
