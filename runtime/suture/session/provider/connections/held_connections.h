#pragma once
// These are the connections of one peer, and what its plain clients have opened.

#include <suture/names/records.h>
#include <suture/session/provider/connections/client_leases.h>
#include <suture/session/provider/shared/shared_by_sessions.h>
#include <suture/wiring/endpoint.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace suture {

/// Belongs to the control thread. Bounds how many there are, watches their leases, and ends them
/// with the session.
class HeldConnections {
 public:
  /// Each connection has its own mailbox for as long as the session lives.
  static constexpr std::size_t kMost = 1024;

  /// A Room is what one of them takes, from the question on, because an answer may take long. It is
  /// free again when the last copy goes.
  struct Room {
    Places::Place place;
    ChannelMemory::Share memory;
  };

  /// `peer` is who has proved to be behind the session, and `state` what is known of it.
  HeldConnections(SharedBySessions& shared, std::string peer, std::shared_ptr<PeerState> state);

  /// Takes a place for one more; or returns why there is none.
  std::optional<Refusal> whyNoPlace(const Endpoint& endpoint, Room& room);
  /// Holds in `room` the memory that a connection to `endpoint` needs; or returns why it may not
  /// have it.
  std::optional<Refusal> whyNoMemory(const Endpoint& endpoint, const Room& room, std::size_t bytes);
  /// Holds a connection until its channel is closed.
  void keep(kj::Own<ProviderEnd> end, const std::shared_ptr<Channel>& channel, Room room);

  ClientLeases& leases() { return leases_; }
  /// At each heartbeat: forgets those that have ended, and tells the clients of the others what has
  /// become of earlier ones.
  void look();
  /// Ends them all.
  void end();

 private:
  struct Held {
    kj::Own<ProviderEnd> end;
    std::shared_ptr<Channel> channel;
    Places::Place place;
  };

  /// Returns true if there were any.
  bool forgetEnded();

  SharedBySessions& shared_;
  const std::string peer_;
  ClientLeases leases_;
  Places places_;
  std::vector<Held> held_;
  bool anyEnded_ = false;  // of those, as the last heartbeat found
};

}  // namespace suture
