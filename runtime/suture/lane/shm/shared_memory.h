#pragma once
// These hand out memory blocks as capabilities over the control link, for the shm lane. All are for
// the control thread.

#include <suture/loop/kj_comparisons.h>  // first

#include <suture/base/memory_block.h>
#include <suture/lane/shm/shared_channel.h>
#include <suture/shm.capnp.h>

#include <memory>

namespace suture::shm {

/// Hands out the descriptor of `block`, and keeps it for as long as the capability exists.
wire::SharedMemory::Client handOut(std::shared_ptr<MemoryBlock> block);

/// Resolves to the block behind a capability. Rejects if it has none, as over TCP, or is not what
/// MemoryBlock demands.
kj::Promise<std::shared_ptr<MemoryBlock>> receive(wire::SharedMemory::Client memory,
                                                  std::size_t size, MemoryBlock::Others others);

/// Hands out the blocks of `parts`, and writes how the state table is divided.
void toWire(const shm::SharedParts& parts, wire::SharedChannel::Builder out);
/// Resolves to the parts that toWire() wrote in the provider's process. Rejects as the other
/// receive() does, or if they would take too much memory.
kj::Promise<shm::SharedParts> receive(wire::SharedChannel::Reader in,
                                      const InterfaceInfo& contract);

}  // namespace suture::shm
