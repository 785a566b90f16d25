#pragma once
// This is the lane of memory that two processes of a machine share.

#include <suture/lane/lane_kind.h>

#include <string>

namespace suture::shm {

class SharedLane final : public LaneKind {
 public:
  const char* name() const override { return "shm"; }
  std::string whyNever(const InterfaceInfo& contract, bool byUnixSocket) const override;
  kj::Own<LaneClient> makeClient(ClientSession& session) override;
  kj::Own<LaneServer> makeServer(ServerSession& session) override;
};

}  // namespace suture::shm
