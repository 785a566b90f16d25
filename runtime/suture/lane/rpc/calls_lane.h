#pragma once
// The lane of Cap'n Proto calls: one socket a session for its connections with small messages, and
// one for each with large ones, which would hold up the others.

#include <suture/lane/lane_kind.h>

namespace suture::rpc {

class CallsLane final : public LaneKind {
 public:
  const char* name() const override { return "rpc"; }
  kj::Own<LaneClient> makeClient(ClientSession& session) override;
  kj::Own<LaneServer> makeServer(ServerSession& session) override;
};

}  // namespace suture::rpc
