#include <suture/base/slots/scratch.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace suture {
namespace {

struct Block {
  std::size_t bytes;
  std::unique_ptr<std::byte[]> memory;
};

/// Holds the calling thread's blocks that are not in use. Taking a block also reserves the room to
/// put it back, so that putting it back never allocates.
struct Unused {
  std::vector<Block> blocks;
  std::size_t inUse = 0;
};

Unused& unused() {
  thread_local Unused blocks;
  return blocks;
}

}  // namespace

ScratchMemory::ScratchMemory(std::size_t bytes) : bytes_(bytes) {
  Unused& store = unused();
  // Take the smallest that is large enough, so that a small value does not take what a large one
  // will need.
  const auto found = std::min_element(store.blocks.begin(), store.blocks.end(),
                                      [&](const Block& a, const Block& b) {
                                        if ((a.bytes >= bytes) != (b.bytes >= bytes))
                                          return a.bytes >= bytes;
                                        return a.bytes < b.bytes;
                                      });
  if (found != store.blocks.end() && found->bytes >= bytes) {
    bytes_ = found->bytes;
    memory_ = found->memory.release();
    store.blocks.erase(found);
  } else {
    store.blocks.reserve(store.blocks.size() + store.inUse + 1);
    memory_ = std::make_unique_for_overwrite<std::byte[]>(bytes).release();
  }
  ++store.inUse;
}

ScratchMemory::~ScratchMemory() {
  Unused& store = unused();
  --store.inUse;
  store.blocks.push_back({bytes_, std::unique_ptr<std::byte[]>(memory_)});
}

void reserveScratch(std::size_t bytes) {
  if (bytes <= kLargestOnStack) return;
  const ScratchMemory first(bytes), second(bytes);
}

}  // namespace suture
