#pragma once
// This is the lane of calls in the client's process.

#include <suture/lane/lane_kind.h>
#include <suture/lane/rpc/calls_link.h>
#include <suture/loop/opened_once.h>

#include <memory>
#include <vector>

namespace suture::rpc {

class CallsClient final : public LaneClient {
 public:
  explicit CallsClient(ClientSession& session) : session_(session) {}

  std::string whyNot(const OutgoingConnection&) const override { return ""; }
  kj::Promise<kj::Own<LaneAttempt>> attempt(const OutgoingConnection& connection) override;
  void bear(Duration silence) override;

 private:
  kj::Promise<std::shared_ptr<CallsLink>> open();
  kj::Promise<std::shared_ptr<CallsLink>> linkFor(const InterfaceInfo& contract);

  ClientSession& session_;
  Duration longest_{0};
  std::vector<std::weak_ptr<CallsLink>> links_;
  loop::OpenedOnce<CallsLink> shared_;
};

}  // namespace suture::rpc
