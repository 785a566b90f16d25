#pragma once
// This is the lane of memory that two processes of a machine share.

#include <suture/lane/lane_kind.h>

#include <string>

namespace suture::shm {

class SharedLane final : public LaneKind {
 public:
  const char* name() const override { return "shm"; }
  kj::Own<LaneClient> makeClient(ClientSession& session) override;
  kj::Own<LaneServer> makeServer(ServerSession& session) override;
};

/// Returns why no two processes can share the memory of such a connection, whatever they are; "" if
/// some can. `byUnixSocket` says how they reach each other.
std::string whyNever(const InterfaceInfo& contract, bool byUnixSocket);

}  // namespace suture::shm
