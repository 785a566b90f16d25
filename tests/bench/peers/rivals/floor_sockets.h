#pragma once
// Plain structs go through sockets behind a header of eight bytes: the floor of what does so.

#include "harness/peer.h"

namespace peers {

class SocketPeer : public Peer {
 public:
  explicit SocketPeer(bool tcp) : tcp_(tcp) {}

  void serve(const Options& options, const Sink& sink, const std::function<void()>& ready) override;
  std::unique_ptr<Client> client(const Options& options, int server) override;

 private:
  const bool tcp_;  ///< else Unix sockets
};

}  // namespace peers
