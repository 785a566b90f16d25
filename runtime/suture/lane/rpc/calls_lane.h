#pragma once
// This is the lane of Cap'n Proto calls: a session has one socket for all of its connections with
// small messages, and one for each connection with large ones, which would hold up the others.

#include <suture/lane/lane_kind.h>

namespace suture::rpc {

class CallsLane final : public LaneKind {
 public:
  const char* name() const override { return "rpc"; }
  kj::Own<LaneClient> makeClient(ClientSession& session) override;
  kj::Own<LaneServer> makeServer(ServerSession& session) override;
};

}  // namespace suture::rpc
