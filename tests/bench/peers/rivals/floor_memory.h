#pragma once
// Plain structs go through a ring in shared memory each way: the floor of what does so.

#include "harness/peer.h"
#include "rivals/floor_ring.h"

namespace peers {

class MemoryPeer final : public Peer {
 public:
  explicit MemoryPeer(Waiting waiting) : waiting_(waiting) {}

  void serve(const Options& options, const Sink& sink, const std::function<void()>& ready) override;
  std::unique_ptr<Client> client(const Options& options, int server) override;

 private:
  const Waiting waiting_;
};

}  // namespace peers
