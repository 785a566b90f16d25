#pragma once
// This answers one request of a peer to connect.

#include <capnp/capability.h>
#include <suture/peer.capnp.h>
#include <suture/session/provider/connections/held_connections.h>
#include <suture/session/provider/lane_servers.h>
#include <suture/session/provider/served_peer.h>
#include <suture/wiring/connect.h>

#include <optional>
#include <string>

namespace suture {

/// Belongs to the control thread; outlives its promise. Compares the contracts, finds out whether
/// the client may take over, and has the lane that was asked for make the provider's end.
class Acceptance {
 public:
  using Context = capnp::CallContext<wire::ConnectRequest, wire::ConnectResults>;

  /// The first three outlive it.
  Acceptance(ServedPeer& peer, HeldConnections& held, LaneServers& lanes, Context context);

  /// Accepts, refuses or declines. Call it once.
  kj::Promise<void> answer();

 private:
  std::optional<Refusal> whyWithheld();
  /// Throws SetupError if there is no such interface.
  kj::Promise<void> decide();
  /// Throws SetupError if the client's side of the connection does not fit `provided`.
  void compare(ProvidedBase& provided);
  /// Returns false, and refuses the request, if a later one has come first.
  bool mayTakeOver();
  IncomingConnection incoming(ProvidedBase& provided) const;
  kj::Promise<void> accept();
  /// Resolves to the end that the lane makes; nothing: the request has been refused.
  kj::Promise<kj::Maybe<AcceptedEnd>> make(LaneServer& lane);
  void accepted(AcceptedEnd made);
  /// Tells the caller why it cannot have that lane, and the operator if something went wrong.
  void decline(const kj::Exception& why);
  LatestConnections::Latest latest(ProviderEnd* end) const;

  ServedPeer& peer_;
  HeldConnections& held_;
  LaneServers& lanes_;
  Context context_;
  const wire::ConnectRequest::Reader asked_;
  const Endpoint endpoint_;
  HeldConnections::Room room_;
  std::string name_;    // of the connection
  std::string client_;  // the required interface, as Admission::proven() returns it
  Match match_{};
  std::optional<IncomingConnection> connection_;
};

}  // namespace suture
