#include <suture/lane/rpc/calls_client.h>
#include <suture/lane/rpc/calls_lane.h>
#include <suture/lane/rpc/calls_server.h>

namespace suture::rpc {

kj::Own<LaneClient> CallsLane::makeClient(ClientSession& session) {
  return kj::heap<CallsClient>(session);
}

kj::Own<LaneServer> CallsLane::makeServer(ServerSession& session) {
  return kj::heap<CallsServer>(session);
}

}  // namespace suture::rpc
