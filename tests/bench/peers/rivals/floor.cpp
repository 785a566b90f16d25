// The floors show what the machine itself takes, without any middleware.

#include "harness/fail.h"
#include "harness/hand_packer.h"
#include "harness/keep.h"
#include "harness/peer_main.h"
#include "rivals/floor_memory.h"
#include "rivals/floor_sockets.h"

namespace peers {
namespace {

/// It packs by hand, and carries nothing.
class PackingPeer final : public SocketPeer {
 public:
  PackingPeer() : SocketPeer(true) {}

  std::size_t convert(const Pose& pose, Pose& back) override {
    unsigned char bytes[kMostPackedBytes];
    const std::size_t size = pack(pose, bytes);
    keep(bytes);
    if (!unpack(bytes, size, back)) fail("what was packed cannot be unpacked");
    return size;
  }
};

std::unique_ptr<Peer> peerOf(const std::string& variant) {
  if (variant == "tcp") return std::make_unique<SocketPeer>(true);
  if (variant == "unix") return std::make_unique<SocketPeer>(false);
  if (variant == "futex") return std::make_unique<MemoryPeer>(Waiting::Futex);
  if (variant == "spin") return std::make_unique<MemoryPeer>(Waiting::Spinning);
  if (variant == "packer") return std::make_unique<PackingPeer>();
  return nullptr;
}

}  // namespace
}  // namespace peers

int main(int count, char** arguments) { return peers::peerMain(count, arguments, peers::peerOf); }
