#pragma once
// This is a socket of the rpc lane in the client's process.

#include <suture/calls.capnp.h>
#include <suture/framing/link.h>
#include <suture/lane/lane_kind.h>

#include <memory>

namespace suture::rpc {

/// Belongs to the control thread. It is shared by the connections whose calls it carries.
class CallsLink {
 public:
  CallsLink(loop::ControlThread& control, LaneSocket socket);

  std::uint32_t number() const { return number_; }
  /// Returns true if the socket carries nothing any more. The control thread's pumps run when that
  /// happens.
  bool broken() const { return broken_; }
  std::shared_ptr<const framing::LinkCounters> counters() const { return link_.counters(); }
  /// Returns the capability of a connection's contract; `counts` gets the outcomes of its commands.
  capnp::Capability::Client contract(std::uint32_t connection, wire::CommandCounts::Client counts);
  /// Tells the kernel how long to wait for an answer to what was sent.
  void bear(Duration silence) const;

 private:
  const std::uint32_t number_;
  const int socket_;
  framing::Link link_;
  wire::Calls::Client peer_;
  bool broken_ = false;
  kj::Promise<void> ending_;  // last: cancelled first
};

}  // namespace suture::rpc
