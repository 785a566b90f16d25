#pragma once
// The lane of calls in the client's process.

#include <suture/calls.capnp.h>
#include <suture/framing/link.h>
#include <suture/lane/lane_kind.h>
#include <suture/lane/opened_once.h>

#include <memory>
#include <vector>

namespace suture::rpc {

/// A socket for calls, as the client has it.
class CallsLink {
 public:
  CallsLink(ControlThread& control, LaneSocket socket);

  std::uint32_t number() const { return number_; }
  bool broken() const { return broken_; }
  /// Resolves with the reason, in words.
  kj::Promise<std::string> whenBroken() { return whenBroken_.addBranch(); }
  std::shared_ptr<const LinkCounters> counters() const { return link_.counters(); }
  /// Returns the capability of a connection's contract; `counts` is told what becomes of its
  /// commands.
  capnp::Capability::Client contract(std::uint32_t connection, wire::CommandCounts::Client counts);
  /// How long the kernel waits for an answer to what was sent.
  void bear(Duration silence) const;

 private:
  const std::uint32_t number_;
  const int socket_;
  Link link_;
  wire::Calls::Client peer_;
  bool broken_ = false;
  kj::ForkedPromise<std::string> whenBroken_;  // last: cancelled first
};

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
  OpenedOnce<CallsLink> shared_;
};

}  // namespace suture::rpc
